#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/shader_program.h"
#include "screen/screen.h"

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
    int width() const { return view_.width; }
    int height() const { return view_.height; }
    /// The background's linear depth.
    float far_depth() const { return static_cast<float>(view_.far); }
    /// The texture of that input, 0 when it was not drawn.
    GLuint texture(const std::string& input) const;

    GBufferImages read() const;
    std::string digest() const;

    /// The camera's uniforms of shaders/contract/view.glsl, for this G-buffer or any pass over it.
    void set_view_uniforms(const ShaderProgram& program) const;
    const CameraFrame& frame() const { return *frame_; }
    /// ORTHOGRAPHIC of shaders/contract/view.glsl.
    bool orthographic() const { return view_.orthographic; }

  private:
    void allocate(const std::set<std::string>& inputs);
    const ShaderProgram& program(bool cutout);
    void draw_mesh(const SceneGeometry& geometry, const SceneGeometry::Draw& draw,
                   const ShaderProgram& program) const;

    std::optional<CameraFrame> frame_;
    ViewUniforms view_;
    glm::dmat4 view_from_scene_{1.0}, clip_from_view_{1.0};

    std::vector<std::string> outputs_;  // colour attachments in order
    std::map<std::string, gl::Texture> textures_;
    gl::Framebuffer framebuffer_;
    std::map<std::string, ShaderProgram> programs_;  // by macros
};

}  // namespace aoscore
