#pragma once

#include "core/image.h"
#include "image/channels.h"
#include "scene/camera.h"
#include "screen/gbuffer/capture.h"
#include "screen/gbuffer/scene_drawing.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gbuffer/view_uniforms.h"
#include "screen/gl/shader_program.h"
#include "screen/screen.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The textures that methods read, drawn from a scene's triangles. Row 0 of every texture is the picture's
/// top row. Functions without a picture's index refer to the first picture.
class GBuffer {
  public:
    /// Draws a capture in place of the one before. Layers behind the first are peeled off (Everitt,
    /// Interactive Order-Independent Transparency, 2001): each holds the surfaces next behind the layer in
    /// front of it. Throws internal_error for an unknown channel, and for cameras of several sizes.
    void draw(const SceneGeometry& geometry, const Capture& capture);

    /// Takes pictures that were drawn elsewhere in place of the one before: linear depth, and those channels
    /// of `capture` that they have. The capture must be of one picture.
    void take(const GBufferImages& images, const Capture& capture);

    bool drawn() const { return !pictures_.empty(); }
    int width() const { return pictures_.front().view.width; }
    int height() const { return pictures_.front().view.height; }
    /// The background's linear depth.
    float far_depth(const CaptureIndex& index = {}) const {
        return static_cast<float>(picture(index).view.far);
    }
    /// The texture of that channel, 0 when it was not drawn.
    GLuint texture(std::string_view channel, const CaptureIndex& index = {}) const;

    GBufferImages read(const CaptureIndex& index = {}) const;
    /// The size of all pictures' textures.
    std::size_t bytes() const;
    /// The digest of all pictures.
    std::string digest() const;

    /// Sets the camera's uniforms of shaders/contract/view.glsl, for this G-buffer or any pass over it.
    void set_view_uniforms(const ShaderProgram& program, const CaptureIndex& index = {}) const;
    const Capture& capture() const { return *capture_; }
    /// The geometry that was drawn, which must still exist; there is none where pictures were taken.
    const SceneGeometry& geometry() const { return *geometry_; }
    const CameraFrame& frame(const CaptureIndex& index = {}) const { return capture_->camera(index); }
    /// The value of ORTHOGRAPHIC in shaders/contract/view.glsl.
    bool orthographic() const { return pictures_.front().view.orthographic; }

  private:
    struct Picture {
        ViewUniforms view;
        std::map<std::string, gl::Texture, std::less<>> textures;
    };
    const Picture& picture(const CaptureIndex& index) const { return pictures_[capture_->place(index)]; }
    /// Makes the textures of a picture, and binds them for drawing.
    void allocate(Picture& made);
    void clear(const Picture& cleared) const;
    /// Draws a picture; `before` is the window depth of the layer in front, 0 for the first.
    void draw_picture(const CameraFrame& frame, const Picture& drawn, GLuint before);
    /// The macros that assign channels to the outputs of scene.frag.
    std::string output_macros() const;

    const SceneGeometry* geometry_ = nullptr;
    std::optional<Capture> capture_;
    std::vector<const Channel*> outputs_;  // colour attachments in order
    std::vector<Picture> pictures_;        // indexed by Capture::place()
    gl::Framebuffer framebuffer_;
    SceneDrawing drawing_{"G-buffer", "scene.frag"};
};

}  // namespace aoscore
