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

    /// Forgets inputs that were computed from the G-buffer, or drawn beside it.
    void forget_derived() {
        derived_.forget();
        layers_.forget();
    }

    DepthLayerBuffer& depth_layers() { return layers_; }

  private:
    GLuint noise(std::uint64_t seed);
    GLuint depth_mips(const PassBuild& build, GLuint linear_depth);
    GLuint linear_depth(Precision precision);
    GLuint normal(const std::string& input, Precision precision);
    GLuint drawn(const std::string& input) const;

    const GBuffer* gbuffer_;
    DerivedInputs derived_;
    DepthLayerBuffer layers_;
    std::map<std::uint64_t, gl::Texture> noise_4x4_;
};

}  // namespace aoscore
