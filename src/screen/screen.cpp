#include "screen/screen.h"

#include "core/error.h"
#include "core/hash.h"
#include "screen/derived_inputs.h"
#include "screen/gbuffer.h"
#include "screen/kernel.h"
#include "screen/osmesa_context.h"
#include "screen/pass_program.h"
#include "screen/scene_geometry.h"
#include "screen/texture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>

namespace aoscore {
namespace {

class Clock {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string gl_text(GLenum name) {
    const GLubyte* text = gl::GetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

// The input that is read in place of a listed one.
std::string replaced_normal(const std::string& input, Normals normals) {
    if (!input.starts_with("normal_")) return input;
    switch (normals) {
        case Normals::as_described:
            return input;
        case Normals::geometric:
            return "normal_geometric";
        case Normals::smooth:
            return "normal_smooth";
        case Normals::from_depth:
            return "normal_from_depth";
        case Normals::from_depth_accurate:
            return "normal_from_depth_accurate";
    }
    return input;
}

}  // namespace

std::set<std::string> needed_gbuffer_inputs(const MethodRequest& request) {
    std::set<std::string> needed = {"linear_depth"};
    for (const MethodDescriptor* descriptor : {request.method, request.filter}) {
        if (descriptor == nullptr) continue;
        for (const Pass& pass : descriptor->passes) {
            for (const std::string& listed : pass.inputs) {
                const std::string input = replaced_normal(listed, request.normals);
                if (gbuffer_inputs().contains(input)) needed.insert(input);
            }
        }
    }
    return needed;
}

struct ScreenRenderer::Impl {
    GlContext context;
    std::optional<SceneGeometry> geometry;
    GBuffer gbuffer;
    DerivedInputs derived;
    gl::VertexArray empty_vertices;  // a core context draws nothing without one
    std::map<std::string, PassProgram> programs;
    std::set<std::string> checked_inputs;
    std::map<std::uint64_t, gl::Texture> noise_4x4;
    gl::Texture raw, filtered, fetches;
    int target_width = 0, target_height = 0;

    Impl() {
        gl::load_functions();
        empty_vertices = gl::VertexArray::create();
        gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    void require_gbuffer() const {
        if (!gbuffer.drawn()) throw internal_error("no G-buffer was drawn", "ScreenRenderer");
    }

    void allocate_targets() {
        if (target_width == gbuffer.width() && target_height == gbuffer.height()) return;
        target_width = gbuffer.width();
        target_height = gbuffer.height();
        raw = make_texture(kR32F, target_width, target_height);
        filtered = make_texture(kR32F, target_width, target_height);
        fetches = make_texture(kR32F, target_width, target_height);
    }

    const PassProgram& program(const PassBuild& build, const Pass& pass) {
        const ShaderSource source = pass_source(build, pass);
        const std::string key = Digest().text(source.text()).text(build.method->folder.string()).hex();
        const auto found = programs.find(key);
        if (found != programs.end()) return found->second;
        const PassProgram& made = programs.emplace(key, PassProgram(build, pass, source)).first->second;
        check_listed_inputs(build, pass, made);
        return made;
    }

    // A listed input that this setting does not sample may belong to another setting: only the form that
    // leaves all settings open can tell.
    void check_listed_inputs(const PassBuild& build, const Pass& pass, const PassProgram& made) {
        if (made.samplers().size() == pass.inputs.size()) return;
        if (!checked_inputs.insert((build.method->folder / pass.fragment).string()).second) return;
        PassBuild open = build;
        open.uniform_form = true;
        const PassProgram all(open, pass, pass_source(open, pass));
        for (const std::string& input : pass.inputs) {
            if (std::find(all.samplers().begin(), all.samplers().end(), input) == all.samplers().end()) {
                throw file_error(fmt::format("lists the input \"{}\", which it never samples", input),
                                 (build.method->folder / "method.json").string() + ": " + pass.fragment);
            }
        }
    }

    GLuint noise_texture(std::uint64_t seed) {
        auto found = noise_4x4.find(seed);
        if (found == noise_4x4.end()) {
            const auto noise = generate_noise_4x4(seed);
            found = noise_4x4
                        .emplace(seed, make_texture(kRgba32F, noise.width, noise.height, noise.pixels.data()))
                        .first;
        }
        return found->second.name();
    }

    GLuint depth_mips(const PassBuild& build) {
        const DepthMips& mips = build.method->depth_mips;
        const double radius =
            mips.radius_parameter.empty() ? 0 : build.parameters->at(mips.radius_parameter).get<double>();
        return derived.depth_mips(gbuffer, mips.filter, radius);
    }

    GLuint input_texture(const std::string& listed, const PassBuild& build, Normals normals) {
        const std::string input = replaced_normal(listed, normals);
        if (input == "visibility") return raw.name();
        if (input == "noise_4x4") return noise_texture(build.seed);
        if (input == "depth_mips") return depth_mips(build);
        if (input == "normal_from_depth") return derived.normal_from_depth(gbuffer, false);
        if (input == "normal_from_depth_accurate") return derived.normal_from_depth(gbuffer, true);
        const GLuint texture = gbuffer.texture(input);
        if (texture == 0) throw internal_error("the G-buffer was drawn without " + input, "ScreenRenderer");
        return texture;
    }

    // Background pixels keep 1 and, in a second target, 0.
    void draw_pass(const PassBuild& build, const Pass& pass, std::initializer_list<GLuint> targets, Normals normals) {
        const PassProgram& compiled = program(build, pass);
        // Inputs first: making one draws by itself.
        std::vector<GLuint> inputs;
        for (const std::string& input : compiled.samplers()) inputs.push_back(input_texture(input, build, normals));
        const gl::Framebuffer framebuffer = make_framebuffer(targets);
        gl::Viewport(0, 0, target_width, target_height);
        const std::array<float, 4> open = {1, 1, 1, 1};
        const std::array<float, 4> zero = {0, 0, 0, 0};
        gl::ClearBufferfv(GL_COLOR, 0, open.data());
        if (targets.size() > 1) gl::ClearBufferfv(GL_COLOR, 1, zero.data());
        compiled.program().use();
        for (std::size_t i = 0; i < compiled.samplers().size(); ++i) {
            const std::string& input = compiled.samplers()[i];
            gl::ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
            gl::BindTexture(GL_TEXTURE_2D, inputs[i]);
            gl::Uniform1i(compiled.program().location("u_" + input), static_cast<GLint>(i));
        }
        gl::ActiveTexture(GL_TEXTURE0);
        gbuffer.set_view_uniforms(compiled.program());
        gl::Uniform1ui(compiled.program().location("u_seed"), static_cast<GLuint>(build.seed));
        if (build.uniform_form) compiled.set_parameters(build);
        gl::BindVertexArray(empty_vertices.name());
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
        gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl::check(build.method->id.c_str());
    }

    PassBuild method_build(const MethodRequest& request) const {
        PassBuild build;
        build.method = request.method;
        build.parameters = &request.parameters;
        build.seed = request.seed;
        build.orthographic = gbuffer.orthographic();
        build.border_far = request.border == Border::far;
        build.uniform_form = request.uniform_form;
        return build;
    }
    PassBuild filter_build(const MethodRequest& request) const {
        PassBuild build = method_build(request);
        build.method = request.filter;
        build.parameters = &request.filter_parameters;
        return build;
    }

    void draw_method(const MethodRequest& request) {
        draw_pass(method_build(request), request.method->passes.front(), {raw.name()}, request.normals);
    }
    void draw_filter(const MethodRequest& request) {
        draw_pass(filter_build(request), request.filter->passes.front(), {filtered.name()}, request.normals);
    }

    ImageF read(const gl::Texture& texture) const {
        ImageF image(target_width, target_height);
        read_texture(texture.name(), GL_RED, image.pixels.data());
        return image;
    }
};

ScreenRenderer::ScreenRenderer() : impl_(std::make_unique<Impl>()) {}

ScreenRenderer::~ScreenRenderer() {
    // Objects are deleted in their own context.
    impl_->context.make_current();
}

std::string ScreenRenderer::renderer() const {
    impl_->context.make_current();
    return gl_text(GL_RENDERER);
}

std::string ScreenRenderer::version() const {
    impl_->context.make_current();
    return gl_text(GL_VERSION);
}

void ScreenRenderer::set_scene(const Scene& scene) {
    impl_->context.make_current();
    impl_->geometry.emplace(scene);
}

double ScreenRenderer::draw_gbuffer(const CameraFrame& frame, const std::set<std::string>& inputs) {
    impl_->context.make_current();
    if (!impl_->geometry) throw internal_error("no scene was set", "ScreenRenderer");
    const Clock clock;
    impl_->derived.forget();
    impl_->gbuffer.draw(*impl_->geometry, frame, inputs);
    return clock.milliseconds();
}

GBufferImages ScreenRenderer::read_gbuffer() {
    impl_->context.make_current();
    impl_->require_gbuffer();
    return impl_->gbuffer.read();
}

std::string ScreenRenderer::gbuffer_digest() {
    impl_->context.make_current();
    impl_->require_gbuffer();
    return impl_->gbuffer.digest();
}

MethodOutput ScreenRenderer::run(const MethodRequest& request) {
    impl_->context.make_current();
    impl_->require_gbuffer();
    impl_->allocate_targets();
    impl_->draw_method(request);
    MethodOutput output;
    output.raw = impl_->read(impl_->raw);
    if (request.filter == nullptr) {
        output.visibility = output.raw;
    } else {
        impl_->draw_filter(request);
        output.visibility = impl_->read(impl_->filtered);
    }
    return output;
}

ScreenRenderer::PassTimes ScreenRenderer::time(const MethodRequest& request) {
    impl_->context.make_current();
    impl_->require_gbuffer();
    impl_->allocate_targets();
    // Compiling is not part of a frame.
    for (const Pass& pass : request.method->passes) impl_->program(impl_->method_build(request), pass);
    if (request.filter != nullptr) {
        for (const Pass& pass : request.filter->passes) impl_->program(impl_->filter_build(request), pass);
    }
    impl_->derived.forget();  // what a method has made for itself is on its bill
    gl::Finish();
    PassTimes times;
    const Clock ao;
    impl_->draw_method(request);
    gl::Finish();
    times.ao_ms = ao.milliseconds();
    if (request.filter != nullptr) {
        const Clock filter;
        impl_->draw_filter(request);
        gl::Finish();
        times.filter_ms = filter.milliseconds();
    }
    return times;
}

ImageF ScreenRenderer::count_fetches(const MethodRequest& request) {
    impl_->context.make_current();
    impl_->require_gbuffer();
    impl_->allocate_targets();
    PassBuild build = impl_->method_build(request);
    build.count_fetches = true;
    impl_->draw_pass(build, request.method->passes.front(), {impl_->raw.name(), impl_->fetches.name()},
                     request.normals);
    return impl_->read(impl_->fetches);
}

}  // namespace aoscore
