#pragma once

#include "screen/gbuffer/gbuffer.h"
#include "screen/gbuffer/precision.h"
#include "screen/gl/shader_program.h"
#include "screen/method/method.h"

#include <map>
#include <string>
#include <string_view>

namespace aoscore {

/// Inputs that are computed from the G-buffer when a method asks for them: depth mips and normals from depth.
/// They are kept until forget().
class DerivedInputs {
  public:
    /// The number of levels of "depth_mips", including the full picture.
    static constexpr int kMipLevels = 6;

    /// Forgets all inputs, when the G-buffer has changed or the work is to be timed.
    void forget();

    /// `radius_m` is that of a "weighted" chain.
    /// `linear_depth` is the texture that they are made of.
    GLuint depth_mips(const GBuffer& gbuffer, GLuint linear_depth, const std::string& filter, double radius_m,
                      Mirror mirror);

    /// The view depth that a depth buffer of that format returns (PrecisionFormat::stored), metres; with x
    /// and y where positions are stored.
    GLuint stored_depth(const GBuffer& gbuffer, std::string_view stored);
    /// The normal that is left in that format (PrecisionFormat::normals).
    GLuint stored_normal(const GBuffer& gbuffer, GLuint normal, std::string_view stored);

    /// `linear_depth` at half the resolution, rounded up: one texel of each block of 2x2.
    GLuint half_depth(const GBuffer& gbuffer, GLuint linear_depth);

    /// View-space normals from this linear depth, unit, facing the camera: `accurate` extrapolates from
    /// both sides and takes the better (Wu, Accurate Normal Reconstruction from Depth Buffer, 2019), else the
    /// differences to the right and below, as derivatives of a shader would be.
    GLuint normal_from_depth(const GBuffer& gbuffer, GLuint linear_depth, bool accurate);

  private:
    /// Draws `source` in one of the formats that `of` names.
    const ShaderProgram& storing_program(const GBuffer& gbuffer, const std::string& file,
                                         std::string_view PrecisionFormat::*of, std::string_view stored);
    const ShaderProgram& program(const GBuffer& gbuffer, const std::string& file, const std::string& macros);
    struct Target {
        std::initializer_list<GLuint> textures;
        int width, height;
        int level = 0;
    };
    void draw(const GBuffer& gbuffer, const ShaderProgram& program, GLuint source, const Target& target);

    gl::VertexArray empty_vertices_;
    std::map<std::string, gl::Texture> textures_;
    std::map<std::string, ShaderProgram> programs_;
};

}  // namespace aoscore
