#pragma once

#include "screen/gbuffer/depth_layer_buffer.h"
#include "screen/gbuffer/derived_inputs.h"
#include "screen/gbuffer/gbuffer.h"
#include "screen/passes/pass_program.h"
#include "screen/screen.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {

/// The settings of a request that decide the content of inputs.
struct InputSettings {
    Normals normals = Normals::as_described;
    Precision precision = Precision::full;
};

/// The input that a request reads in place of a listed one, where it asks for other normals.
std::string replaced_normal(const std::string& input, Normals normals);

/// The target of its texture: GL_TEXTURE_2D, or an array of them.
GLenum texture_target(std::string_view input);

/// Finds, or makes, the texture behind each input that a pass lists.
class InputTextures {
  public:
    explicit InputTextures(const GBuffer& gbuffer) : gbuffer_(&gbuffer) {}

    /// "coarser" and "visibility" are the result of the pass before: `previous`. Throws internal_error for an
    /// input that the G-buffer was drawn without.
    GLuint texture(const std::string& listed, const PassBuild& build, const InputSettings& settings,
                   GLuint previous);

    /// Sets the uniforms that belong to inputs, in a program that is in use and samples these.
    void set_uniforms(const ShaderProgram& program, const std::vector<std::string>& inputs,
                      const PassBuild& build) const;

    /// Forgets inputs that were computed from the G-buffer, or drawn beside it.
    void forget_derived() {
        derived_.forget();
        layers_.forget();
        side_layers_.forget();
    }

    /// Depth layers that were drawn beside the G-buffer.
    struct Layers {
        DepthLayerBuffer::Drawing main, side;
    };
    Layers take_layers() { return {layers_.take(), side_layers_.take()}; }
    void put_back(Layers layers) {
        layers_.put_back(std::move(layers.main));
        side_layers_.put_back(std::move(layers.side));
    }

    void set_ray_layers(const RayLayerSource* source) {
        layers_.set_ray_layers(source);
        side_layers_.set_ray_layers(source);
    }
    DepthLayerBuffer& depth_layers() { return layers_; }
    std::uint64_t layered_pictures_drawn() const { return layers_.drawings() + side_layers_.drawings(); }

  private:
    GLuint noise(std::uint64_t seed);
    GLuint depth_mips(const PassBuild& build, GLuint linear_depth);
    GLuint linear_depth(Precision precision);
    GLuint normal(const std::string& input, Precision precision);
    GLuint drawn(const std::string& input) const;
    LayeredPictures side_pictures(const PassBuild& build) const;

    const GBuffer* gbuffer_;
    DerivedInputs derived_;
    DepthLayerBuffer layers_, side_layers_;
    std::map<std::uint64_t, gl::Texture> noise_4x4_;
};

}  // namespace aoscore
