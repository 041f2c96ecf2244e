#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/scene_geometry.h"
#include "screen/screen.h"
#include "screen/shader_program.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The textures that methods read, drawn from a scene's triangles. Row 0 of every texture is the picture's
/// top row.
class GBuffer {
  public:
    /// Draws linear and hardware depth, and what `inputs` names beside them; drops what it does not name.
    void draw(const SceneGeometry& geometry, const CameraFrame& frame, const std::set<std::string>& inputs);

    bool drawn() const { return !textures_.empty(); }
    int width() const { return width_; }
    int height() const { return height_; }
    /// The background's linear depth.
    float far_depth() const { return static_cast<float>(far_); }
    /// The texture of that input, 0 when it was not drawn.
    GLuint texture(const std::string& input) const;

    GBufferImages read() const;
    std::string digest() const;

    /// The camera's uniforms of shaders/contract/view.glsl, for this G-buffer or any pass over it.
    void set_view_uniforms(const ShaderProgram& program) const;
    const CameraFrame& frame() const { return *frame_; }
    /// ORTHOGRAPHIC of shaders/contract/view.glsl.
    bool orthographic() const { return orthographic_; }

  private:
    void allocate(const std::set<std::string>& inputs);
    const ShaderProgram& program(bool cutout);
    void draw_mesh(const SceneGeometry& geometry, const SceneGeometry::Draw& draw,
                   const ShaderProgram& program) const;

    int width_ = 0, height_ = 0;
    std::optional<CameraFrame> frame_;
    glm::dvec2 pixel_size_{0};
    double near_ = 0, far_ = 0;
    bool orthographic_ = false;
    glm::dmat4 view_from_scene_{1.0}, clip_from_view_{1.0};

    std::vector<std::string> outputs_;  // colour attachments in order
    std::map<std::string, gl::Texture> textures_;
    gl::Framebuffer framebuffer_;
    std::map<std::string, ShaderProgram> programs_;  // by macros
};

}  // namespace aoscore
