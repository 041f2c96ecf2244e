#pragma once

#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/gl_objects.h"
#include "screen/gl/shader_program.h"

#include <map>
#include <string>

namespace aoscore {

/// The window depth of every texel's farthest sample of depth layers, as a depth buffer: fragments that it
/// hides change no sample, and a test against it keeps them from being shaded.
class FarthestSamples {
  public:
    /// Draws it of so many samples, which begin at this texture of an array as DepthLayerBuffer has it, and
    /// returns the depth texture, which stays until the next drawing.
    GLuint draw(GLuint array, int first_texture, int samples, const ViewUniforms& view);

  private:
    const ShaderProgram& program(int samples, bool orthographic);

    gl::VertexArray empty_vertices_;
    gl::Texture depth_;
    int width_ = 0, height_ = 0;
    std::map<std::string, ShaderProgram> programs_;  // indexed by macros
};

}  // namespace aoscore
