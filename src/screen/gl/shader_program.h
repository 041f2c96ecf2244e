#pragma once

#include "screen/gl/gl_objects.h"
#include "screen/passes/shader_source.h"

#include <map>
#include <string>

namespace aoscore {

/// A linked vertex and fragment shader with its active uniforms.
class ShaderProgram {
  public:
    /// Errors call the program `name`. Throws internal_error with the numbered source where the compiler or
    /// the linker complains.
    ShaderProgram(std::string name, const ShaderSource& vertex, const ShaderSource& fragment);

    struct Uniform {
        GLint location = -1;
        GLenum type = 0;
        GLint size = 1;  ///< number of an array's elements
    };
    /// The uniforms by name, without "[0]". Those that the compiler found to have no effect are not among
    /// them.
    const std::map<std::string, Uniform, std::less<>>& uniforms() const { return uniforms_; }
    /// The location of a uniform; -1, which OpenGL ignores, for a name that is not active.
    GLint location(std::string_view uniform) const;

    void use() const;

  private:
    gl::Program program_;
    std::map<std::string, Uniform, std::less<>> uniforms_;
};

}  // namespace aoscore
