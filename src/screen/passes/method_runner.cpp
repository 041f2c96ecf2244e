#include "screen/passes/method_runner.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/hash.h"
#include "core/known_names.h"
#include "screen/gbuffer/precision.h"
#include "screen/gl/texture.h"
#include "screen/method/method_files.h"
#include "screen/passes/processors.h"
#include "screen/trial/shader_trial.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace aoscore {
namespace {

// Values in place of a count of fetches: one where nothing was shaded, and one by which contract/ao_pass.glsl
// reports loops that were cut short.
constexpr float kUnshaded = -1, kLoopsCutShort = -2;

const Processor& processor_of(const Pass& pass) {
    return row_of(processors(), pass.processor, "no processor");
}

constexpr std::array<float, 4> kOpen = {1, 1, 1, 1}, kUnshadedTarget = {kUnshaded, 0, 0, 0};

/// The format of a texture that holds one of its pixels.
TextureFormat format_of(const Signal& signal) {
    return signal.channels.size() == 1 ? kR32F : kRgba32F;
}

int scaled_size(int size, int scale) {
    return std::max((size + scale - 1) / scale, 1);
}

}  // namespace

MethodRunner::MethodRunner(const GBuffer& gbuffer)
    : gbuffer_(&gbuffer), inputs_(gbuffer), empty_vertices_(gl::VertexArray::create()) {}

PassBuild MethodRunner::base_build(const MethodRequest& request, const MethodDescriptor& descriptor,
                                   const ParameterValues& parameters) const {
    PassBuild build;
    build.method = &descriptor;
    build.parameters = &parameters;
    build.seed = request.seed;
    build.orthographic = gbuffer_->orthographic();
    build.border_far = request.border == Border::far;
    build.positions =
        format_of(request.precision).positions && request.resolution != Resolution::half_gbuffer;
    build.uniform_form = request.uniform_form;
    build.mirror = request.mirror;
    return build;
}

void MethodRunner::check_resolution(const MethodRequest& request) const {
    const std::vector<Pass>& passes = request.method->passes;
    const bool processed =
        std::any_of(passes.begin(), passes.end(), [](const Pass& p) { return !p.processor.empty(); });
    if (processed && request.resolution != Resolution::full) {
        throw usage_error("a method of the processor has one resolution", request.method->id, "full");
    }
    if (passes.size() > 1 && request.resolution == Resolution::dual) {
        throw usage_error("a method of several passes has no dual resolution", request.method->id,
                          "full, half, half-gbuffer");
    }
}

void MethodRunner::check_signals(const MethodRequest& request) {
    for (const std::string& id : request.signals) {
        if (!request.method->gives(id)) {
            throw usage_error(
                fmt::format("does not give the signal {}", id), request.method->id,
                fmt::format("visibility, {}", fmt::join(request.method->passes.back().outputs, ", ")));
        }
    }
    const bool full =
        request.resolution == Resolution::full || request.resolution == Resolution::half_gbuffer;
    if (!request.signals.empty() && !full) {
        throw usage_error("signals beside visibility are given at full resolution alone", request.method->id,
                          "full, half-gbuffer");
    }
}

std::vector<MethodRunner::Step> MethodRunner::method_steps(const MethodRequest& request) const {
    check_resolution(request);
    check_signals(request);
    const bool halved = request.resolution == Resolution::half || request.resolution == Resolution::dual;
    std::vector<Step> steps;
    int before = 1;
    for (const Pass& pass : request.method->passes) {
        Step step{&pass, base_build(request, *request.method, request.parameters)};
        step.build.scale = pass.scale * (halved ? 2 : 1);
        step.build.coarser_scale = before;
        step.build.half_taps = request.resolution == Resolution::half_gbuffer;
        if (&pass == &request.method->passes.back()) step.build.signals = request.signals;
        before = step.build.scale;
        steps.push_back(step);
    }
    if (request.resolution == Resolution::dual) {
        Step fine = steps.back();
        fine.build.scale = 1;
        fine.build.coarser_scale = before;
        fine.build.dual = true;
        steps.push_back(fine);
    }
    return steps;
}

std::vector<MethodRunner::Step> MethodRunner::following_steps(const MethodRequest& request,
                                                              const MethodDescriptor* descriptor,
                                                              const ParameterValues& parameters) const {
    std::vector<Step> steps;
    if (descriptor == nullptr) return steps;
    for (const Pass& pass : descriptor->passes)
        steps.push_back({&pass, base_build(request, *descriptor, parameters)});
    return steps;
}

// Tries a user's shader in a process with limits: it may take any time and memory to compile.
void MethodRunner::try_users_shader(const PassBuild& build, const Pass& pass, const ShaderSource& source) {
    const std::filesystem::path& folder = build.method->folder;
    if (!lies_in(folder, shader_library()))
        try_shader(screen_vertex(), source, (folder / pass.fragment).string());
}

const PassProgram* MethodRunner::program(const Step& step) {
    if (!step.pass->processor.empty()) return nullptr;
    const PassBuild& build = step.build;
    const Pass& pass = *step.pass;
    const ShaderSource source = pass_source(build, pass);
    const std::string key = Digest().text(source.text()).text(build.method->folder.string()).hex();
    const auto found = programs_.find(key);
    if (found != programs_.end()) return &found->second;
    try_users_shader(build, pass, source);
    const PassProgram& made = programs_.emplace(key, PassProgram(build, pass, source)).first->second;
    ++compilations_;
    check_listed_inputs(build, pass, made);
    return &made;
}

// Checks that listed inputs are sampled. An input that this setting does not sample may belong to another
// setting, which only the uniform form shows.
void MethodRunner::check_listed_inputs(const PassBuild& build, const Pass& pass, const PassProgram& made) {
    if (made.samplers().size() >= pass.inputs.size()) return;
    if (!checked_inputs_.insert((build.method->folder / pass.fragment).string()).second) return;
    PassBuild open = build;
    open.uniform_form = true;
    ++compilations_;
    const ShaderSource source = pass_source(open, pass);
    try_users_shader(open, pass, source);
    const PassProgram all(open, pass, source);
    for (const std::string& input : pass.inputs) {
        if (std::find(all.samplers().begin(), all.samplers().end(), input) == all.samplers().end()) {
            throw file_error(fmt::format("lists the input \"{}\", which it never samples", input),
                             (build.method->folder / "method.json").string() + ": " + pass.fragment);
        }
    }
}

void MethodRunner::allocate() {
    if (width_ == gbuffer_->width() && height_ == gbuffer_->height()) return;
    width_ = gbuffer_->width();
    height_ = gbuffer_->height();
    for (gl::Texture* target : {&raw_, &first_, &second_, &fetches_})
        *target = make_texture(kR32F, width_, height_);
    scaled_.clear();
    signals_.clear();
    lit_ = gl::Texture();
}

gl::Texture& MethodRunner::scaled_target(std::size_t step, int scale) {
    auto found = scaled_.find({step, scale});
    if (found == scaled_.end()) {
        gl::Texture texture = make_texture(kR32F, scaled_size(width_, scale), scaled_size(height_, scale));
        found = scaled_.emplace(std::pair(step, scale), std::move(texture)).first;
    }
    return found->second;
}

std::vector<MethodRunner::Target> MethodRunner::targets_of(const Step& step, GLuint first) {
    std::vector<Target> targets{{first, kOpen}};
    for (const std::string& id : step.build.signals) {
        gl::Texture& texture = signals_[id];
        if (!texture) texture = make_texture(format_of(signal(id)), width_, height_);
        targets.push_back({texture.name(), {0, 0, 0, 0}});
    }
    return targets;
}

// Draws a pass. The dual mode's fine pass keeps pixels that it does not shade.
void MethodRunner::draw(const Step& step, const std::vector<Target>& targets, const InputSettings& settings,
                        GLuint previous) {
    ++passes_;
    if (step.program == nullptr) {
        process(step, targets.front().texture, settings);
        return;
    }
    const PassProgram& compiled = *step.program;
    // Inputs come first, since making one may draw.
    std::vector<GLuint> textures;
    for (const std::string& input : compiled.samplers()) {
        textures.push_back(inputs_.texture(input, step.build, settings, previous));
    }
    std::vector<GLuint> drawn;
    for (const Target& target : targets) drawn.push_back(target.texture);
    const gl::Framebuffer framebuffer = make_framebuffer(drawn);
    gl::Viewport(0, 0, scaled_size(width_, step.build.scale), scaled_size(height_, step.build.scale));
    for (std::size_t i = step.build.dual ? 1 : 0; i < targets.size(); ++i)
        gl::ClearBufferfv(GL_COLOR, static_cast<GLint>(i), targets[i].clear.data());
    compiled.program().use();
    for (std::size_t i = 0; i < textures.size(); ++i) {
        gl::ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        gl::BindTexture(texture_target(compiled.samplers()[i]), textures[i]);
        gl::Uniform1i(compiled.program().location("u_" + compiled.samplers()[i]), static_cast<GLint>(i));
    }
    gl::ActiveTexture(GL_TEXTURE0);
    gbuffer_->set_view_uniforms(compiled.program());
    inputs_.set_uniforms(compiled.program(), compiled.samplers(), step.build);
    gl::Uniform1ui(compiled.program().location("u_seed"), static_cast<GLuint>(step.build.seed));
    if (step.build.uniform_form) compiled.set_parameters(step.build);
    gl::BindVertexArray(empty_vertices_.name());
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check(step.build.method->id.c_str());
}

void MethodRunner::process(const Step& step, GLuint target, const InputSettings& settings) {
    ImageF depth(width_, height_);
    Image<glm::vec4> normal(width_, height_);
    read_texture(inputs_.texture("linear_depth", step.build, settings, 0), GL_RED, depth.pixels.data());
    read_texture(inputs_.texture("normal_geometric", step.build, settings, 0), GL_RGBA, normal.pixels.data());
    const ProcessorInput input{&gbuffer_->frame(), &depth, &normal, gbuffer_->far_depth()};
    write(target, processor_of(*step.pass).compute(input, *step.build.parameters));
}

void MethodRunner::write(GLuint texture, const ImageF& image) const {
    gl::BindTexture(GL_TEXTURE_2D, texture);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl::TexImage2D(GL_TEXTURE_2D, 0, kR32F.internal, width_, height_, 0, kR32F.transfer, GL_FLOAT,
                   image.pixels.data());
    gl::check("uploading a picture");
}

void MethodRunner::upsample(GLuint coarse, int scale) {
    const std::string macros = fmt::format(
        "#define ORTHOGRAPHIC {}\n#define BORDER_FAR 1\n#define SCALE 1\n#define COARSER_SCALE {}\n#define "
        "HALF_TAPS 0\n"
        "#define DUAL 0\n#define COUNT_FETCHES 0\n",
        gbuffer_->orthographic() ? 1 : 0, scale);
    auto found = upsampling_.find(macros);
    if (found == upsampling_.end()) {
        const auto folder = data_dir() / "shaders" / "gbuffer";
        ShaderSource vertex, fragment;
        vertex.add_file(folder / "screen.vert", folder);
        fragment.add_block("(program's macros)", macros);
        fragment.add_file(folder / "upsample.frag", folder);
        found = upsampling_.emplace(macros, ShaderProgram("upsampling", vertex, fragment)).first;
    }
    const ShaderProgram& p = found->second;
    const gl::Framebuffer framebuffer = make_framebuffer({raw_.name()});
    gl::Viewport(0, 0, width_, height_);
    gl::ClearBufferfv(GL_COLOR, 0, kOpen.data());
    p.use();
    gbuffer_->set_view_uniforms(p);
    gl::ActiveTexture(GL_TEXTURE1);
    gl::BindTexture(GL_TEXTURE_2D, gbuffer_->texture("linear_depth"));
    gl::ActiveTexture(GL_TEXTURE0);
    gl::BindTexture(GL_TEXTURE_2D, coarse);
    gl::Uniform1i(p.location("u_coarser"), 0);
    gl::Uniform1i(p.location("u_linear_depth"), 1);
    gl::BindVertexArray(empty_vertices_.name());
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::check("upsampling");
}

MethodRunner::Frame MethodRunner::prepare(const MethodRequest& request) {
    Frame frame{method_steps(request),
                following_steps(request, request.filter, request.filter_parameters),
                following_steps(request, request.lighting, request.lighting_parameters),
                {request.normals, request.precision}};
    for (std::vector<Step>* steps : {&frame.method, &frame.filter, &frame.lighting}) {
        for (Step& step : *steps) step.program = program(step);
    }
    return frame;
}

bool MethodRunner::draw_depth_layers(const Frame& frame) {
    bool drawn = false;
    for (const Step& step : frame.method) {
        if (step.program == nullptr) continue;
        for (const std::string& input : step.program->samplers()) {
            if (texture_target(input) != GL_TEXTURE_2D_ARRAY) continue;
            inputs_.texture(input, step.build, frame.settings, 0);
            drawn = true;
        }
    }
    return drawn;
}

void MethodRunner::draw_method(const Frame& frame) {
    allocate();
    GLuint previous = 0;
    const std::vector<Step>& steps = frame.method;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const int scale = steps[i].build.scale;
        const GLuint target = scale == 1 ? raw_.name() : scaled_target(i, scale).name();
        draw(steps[i], targets_of(steps[i], target), frame.settings, previous);
        const bool next_is_fine = i + 1 < steps.size() && steps[i + 1].build.dual;
        if (scale > 1 && (i + 1 == steps.size() || next_is_fine)) upsample(target, scale);
        previous = target;
    }
    filtered_ = &raw_;
}

void MethodRunner::take_raw(const ImageF& visibility) {
    allocate();
    if (visibility.width != width_ || visibility.height != height_)
        throw internal_error("a picture of another size than the G-buffer's is to be filtered");
    write(raw_.name(), visibility);
    filtered_ = &raw_;
}

void MethodRunner::draw_filter(const Frame& frame) {
    filtered_ = &raw_;
    for (const Step& step : frame.filter) {
        const gl::Texture* target = filtered_ == &first_ ? &second_ : &first_;
        draw(step, {{target->name(), kOpen}}, frame.settings, filtered_->name());
        filtered_ = target;
    }
}

void MethodRunner::draw_lighting(const Frame& frame) {
    for (const Step& step : frame.lighting) {
        if (!lit_) lit_ = make_texture(kRgba32F, width_, height_);
        draw(step, {{lit_.name(), kOpen}}, frame.settings, filtered_->name());
    }
}

// Replaces the special values of counts. Where a pass has shaded nothing it has fetched nothing; but a pass
// at full resolution must shade all surfaces, and the compiler removes all code after an endless loop, the
// result included.
void MethodRunner::settle_counts(const Step& step, const InputSettings& settings, ImageF& counted) {
    const bool shades_all = step.build.scale == 1 && !step.build.dual;
    // This is the depth that the pass has read: a coarse format may have moved a surface onto the background.
    const ImageF depth =
        shades_all ? read(inputs_.texture("linear_depth", step.build, settings, 0)) : ImageF();
    for (std::size_t i = 0; i < counted.size(); ++i) {
        float& count = counted.pixels[i];
        const bool no_result = shades_all && count == kUnshaded && depth.pixels[i] < gbuffer_->far_depth();
        if (count == kLoopsCutShort || no_result) {
            throw file_error(
                "a pixel's loops turn more often than the rasteriser lets them, which ends them without a "
                "word",
                (step.build.method->folder / step.pass->fragment).string(), "at most 65,535 turns in all");
        }
        count = std::max(count, 0.0F);
    }
}

ImageF MethodRunner::count_fetches(const MethodRequest& request) {
    allocate();
    ImageF total(width_, height_, 0.0F);
    GLuint previous = 0;
    MethodRequest visibility_alone = request;
    visibility_alone.signals.clear();
    auto steps = method_steps(visibility_alone);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const int scale = steps[i].build.scale;
        steps[i].build.count_fetches = true;
        steps[i].program = program(steps[i]);
        const GLuint target = scale == 1 ? raw_.name() : scaled_target(i, scale).name();
        if (steps[i].program == nullptr) {
            const double taps = processor_of(*steps[i].pass).fetches(*steps[i].build.parameters);
            for (float& count : total.pixels) count += static_cast<float>(taps);
            draw(steps[i], {{target, kOpen}}, {request.normals, request.precision}, previous);
            continue;
        }
        const int width = scaled_size(width_, scale), height = scaled_size(height_, scale);
        const gl::Texture counts = make_texture(kR32F, width, height);
        draw(steps[i], {{target, kOpen}, {counts.name(), kUnshadedTarget}},
             {request.normals, request.precision}, previous);
        ImageF counted(width, height);
        read_texture(counts.name(), GL_RED, counted.pixels.data());
        settle_counts(steps[i], {request.normals, request.precision}, counted);
        // A coarse pixel's taps are shared by the pixels that it stands for.
        const float share = 1.0F / static_cast<float>(scale * scale);
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) total.at(x, y) += share * counted.at(x / scale, y / scale);
        }
        previous = target;
    }
    const ImageF depth = read(gbuffer_->texture("linear_depth"));
    for (std::size_t i = 0; i < total.size(); ++i) {
        if (depth.pixels[i] >= gbuffer_->far_depth()) total.pixels[i] = 0;
    }
    return total;
}

SignalImage MethodRunner::signal_image(const std::string& id) const {
    const std::size_t planes = signal(id).channels.size();
    const GLuint texture = signals_.at(id).name();
    if (planes == 1) return {read(texture)};
    Image<glm::vec4> texels(width_, height_);
    read_texture(texture, GL_RGBA, texels.pixels.data());
    SignalImage image(planes, ImageF(width_, height_));
    for (std::size_t plane = 0; plane < planes; ++plane) {
        for (std::size_t i = 0; i < texels.size(); ++i)
            image[plane].pixels[i] = texels.pixels[i][static_cast<glm::length_t>(plane)];
    }
    return image;
}

Image<glm::vec3> MethodRunner::lit() const {
    Image<glm::vec3> image(width_, height_);
    read_texture(lit_.name(), GL_RGB, image.pixels.data());
    return image;
}

ImageF MethodRunner::read(GLuint texture) const {
    ImageF image(width_, height_);
    read_texture(texture, GL_RED, image.pixels.data());
    return image;
}

}  // namespace aoscore
