#include "screen/gbuffer/input_textures.h"

#include "core/error.h"
#include "core/known_names.h"
#include "image/channels.h"
#include "screen/gbuffer/precision.h"
#include "screen/gbuffer/side_cameras.h"
#include "screen/gl/texture.h"
#include "screen/method/kernel.h"

#include <algorithm>

namespace aoscore {
namespace {

constexpr std::string_view kSideLayers = "side_layers";

}  // namespace

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

GLenum texture_target(std::string_view input) {
    const MadeInput* made = find_row(made_inputs(), input);
    return made != nullptr && made->layered ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

std::set<std::string> needed_gbuffer_inputs(const MethodRequest& request) {
    std::set<std::string> needed = {"linear_depth"};
    for (const MethodDescriptor* descriptor : {request.method, request.filter, request.lighting}) {
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

GLuint InputTextures::noise(std::uint64_t seed) {
    auto found = noise_4x4_.find(seed);
    if (found == noise_4x4_.end()) {
        const auto tile = generate_noise_4x4(seed);
        found = noise_4x4_.emplace(seed, make_texture(kRgba32F, tile.width, tile.height, tile.pixels.data()))
                    .first;
    }
    return found->second.name();
}

GLuint InputTextures::texture(const std::string& listed, const PassBuild& build,
                              const InputSettings& settings, GLuint previous) {
    if (listed == "visibility" || listed == "coarser") return previous;
    if (listed == "noise_4x4") return noise(build.seed);
    if (listed == "linear_depth") return linear_depth(settings.precision);
    if (listed == "half_depth") return derived_.half_depth(*gbuffer_, linear_depth(settings.precision));
    if (listed == "depth_layers") {
        return layers_.texture(gbuffer_->geometry(), {asked_depth_layers(*build.method->depth_layers,
                                                                         *build.parameters, build.seed),
                                                      {gbuffer_->frame()},
                                                      build.mirror});
    }
    if (listed == kSideLayers) return side_layers_.texture(gbuffer_->geometry(), side_pictures(build));
    if (listed == "depth_mips") return depth_mips(build, linear_depth(settings.precision));
    if (listed.starts_with("normal_"))
        return normal(replaced_normal(listed, settings.normals), settings.precision);
    return drawn(listed);
}

// A program whose parameters are uniforms samples the input whatever their values are: it gets one camera at
// least.
LayeredPictures InputTextures::side_pictures(const PassBuild& build) const {
    SideLayers side = asked_side_layers(*build.method->side_layers, *build.parameters, build.seed);
    side.cameras = std::max(side.cameras, 1);
    return {side.layers, side_cameras(gbuffer_->frame(), side, build.mirror), build.mirror};
}

void InputTextures::set_uniforms(const ShaderProgram& program, const std::vector<std::string>& inputs,
                                 const PassBuild& build) const {
    if (std::ranges::find(inputs, kSideLayers) != inputs.end())
        set_side_uniforms(program, gbuffer_->frame(), side_pictures(build).cameras);
}

GLuint InputTextures::depth_mips(const PassBuild& build, GLuint linear_depth) {
    const DepthMips& mips = build.method->depth_mips;
    const bool has_radius = !mips.radius_parameter.empty();
    const double radius = has_radius ? build.parameters->at(mips.radius_parameter).number() : 0;
    return derived_.depth_mips(*gbuffer_, linear_depth, mips.filter, radius, build.mirror);
}

GLuint InputTextures::linear_depth(Precision precision) {
    const std::string_view stored = format_of(precision).stored;
    return stored.empty() ? drawn("linear_depth") : derived_.stored_depth(*gbuffer_, stored);
}

GLuint InputTextures::normal(const std::string& input, Precision precision) {
    const bool from_depth = input.starts_with("normal_from_depth");
    const GLuint exact = from_depth ? derived_.normal_from_depth(*gbuffer_, linear_depth(precision),
                                                                 input == "normal_from_depth_accurate")
                                    : drawn(input);
    const std::string_view stored = format_of(precision).normals;
    return stored.empty() ? exact : derived_.stored_normal(*gbuffer_, exact, stored);
}

GLuint InputTextures::drawn(const std::string& input) const {
    const GLuint texture = gbuffer_->texture(input);
    if (texture == 0) throw internal_error("the G-buffer was drawn without " + input, "ScreenRenderer");
    return texture;
}

}  // namespace aoscore
