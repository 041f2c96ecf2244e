#include "screen/input_textures.h"

#include "core/error.h"
#include "screen/kernel.h"
#include "screen/texture.h"

namespace aoscore {

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
    const std::string input = replaced_normal(listed, settings.normals);
    const bool normal = input.starts_with("normal_");
    if (input == "half_depth") {
        return derived_.half_depth(*gbuffer_, texture("linear_depth", build, settings, previous));
    }
    if (settings.precision == Precision::full ||
        (input != "linear_depth" && input != "depth_mips" && !normal)) {
        if (input == "depth_mips") return depth_mips(build, gbuffer_->texture("linear_depth"));
        return unpacked(input, build, previous);
    }
    // Without a normal of the method's own the triangle's is packed along, if there is one: depth does not
    // care.
    const GLuint normal_texture = unpacked(normal ? input : "linear_depth", build, previous);
    const DerivedInputs::Packed packed = derived_.packed(*gbuffer_, normal_texture);
    if (input == "depth_mips") return depth_mips(build, packed.linear_depth);
    return normal ? packed.normal : packed.linear_depth;
}

GLuint InputTextures::depth_mips(const PassBuild& build, GLuint linear_depth) {
    const DepthMips& mips = build.method->depth_mips;
    const bool has_radius = !mips.radius_parameter.empty();
    const double radius = has_radius ? build.parameters->at(mips.radius_parameter).get<double>() : 0;
    return derived_.depth_mips(*gbuffer_, linear_depth, mips.filter, radius);
}

GLuint InputTextures::unpacked(const std::string& input, const PassBuild& build, GLuint previous) {
    if (input == "visibility" || input == "coarser") return previous;
    if (input == "noise_4x4") return noise(build.seed);
    if (input == "normal_from_depth") return derived_.normal_from_depth(*gbuffer_, false);
    if (input == "normal_from_depth_accurate") return derived_.normal_from_depth(*gbuffer_, true);
    const GLuint texture = gbuffer_->texture(input);
    if (texture == 0) throw internal_error("the G-buffer was drawn without " + input, "ScreenRenderer");
    return texture;
}

}  // namespace aoscore
