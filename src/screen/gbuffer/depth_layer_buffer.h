#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/gbuffer/scene_drawing.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gl/gl_objects.h"
#include "screen/method/depth_layers.h"
#include "screen/screen.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace aoscore {

/// Depth layers to be drawn, of one camera or of several of one size.
struct LayeredPictures {
    DepthLayers layers;
    std::vector<CameraFrame> cameras;
    Mirror mirror = Mirror::none;

    bool operator==(const LayeredPictures& other) const;
};

/// Several view depths a texel, metres, the far plane's where a sample is empty: the inputs "depth_layers"
/// and "side_layers". Surfaces are those of the G-buffer: cut-outs have their holes, and both sides of a wall
/// are drawn.
class DepthLayerBuffer {
  public:
    /// Who gathers layers by rays; the function must live as long as this.
    void set_ray_layers(const RayLayerSource* source) { ray_layers_ = source; }

    /// A GL_TEXTURE_2D_ARRAY of four samples a texel, or of two or one where no more are asked for; the
    /// pictures of one camera after those of another. It is drawn unless it was drawn last: only one is kept,
    /// since sixteen samples of 1920x1080 pixels take 133 MB.
    GLuint texture(const SceneGeometry& geometry, const LayeredPictures& wanted);

    /// Draws the scene's surfaces in this order, which does not affect the result. A sample holds the
    /// nearest of the surfaces that it accepts, by blending with the minimum: in one pass without sorting.
    void draw(const SceneGeometry& geometry, const LayeredPictures& wanted,
              std::span<const SceneGeometry::Draw> draws);

    /// Reads the last drawing: a picture for each sample, row 0 at the top; those of one camera after those
    /// of another.
    std::vector<ImageF> read() const;

    /// The number of cameras that were drawn since the buffer was made.
    std::uint64_t drawings() const { return drawings_; }

    /// A drawing, to be kept for its G-buffer while others are in use.
    struct Drawing {
        std::optional<LayeredPictures> pictures;  ///< empty: none
        gl::Texture array;
    };
    /// Takes the last drawing out; empty where it is none or was forgotten.
    Drawing take();
    /// Makes a drawing that was taken out the last one again.
    void put_back(Drawing drawing);

    /// Forgets the last drawing, when the G-buffer has changed or the work is to be timed.
    /// Its memory is kept for the next one of the same shape.
    void forget() { is_stale_ = true; }

  private:
    void allocate(const LayeredPictures& wanted);
    /// Draws one camera's pictures, which begin at this texture of the array.
    void draw_camera(const SceneGeometry& geometry, const CameraFrame& camera, int first_texture,
                     std::span<const SceneGeometry::Draw> draws);
    void blend(const SceneDrawing::Look& look, int first_texture);
    void peel(SceneDrawing::Look look, int first_texture);
    /// Puts layers that rays have met into the pictures.
    void upload(const std::vector<ImageF>& samples, int first_texture);
    std::vector<ImageF> met_by_rays(const CameraFrame& camera) const;

    std::optional<LayeredPictures> drawn_;
    bool is_stale_ = false;  ///< of a G-buffer that is no more, or to be drawn again for the clock
    const RayLayerSource* ray_layers_ = nullptr;
    std::uint64_t drawings_ = 0;
    gl::Texture array_;
    SceneDrawing drawing_{"depth layers", "depth_layers.frag"};
};

}  // namespace aoscore
