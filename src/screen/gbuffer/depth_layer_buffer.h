#pragma once

#include "core/image.h"
#include "screen/gbuffer/gbuffer.h"
#include "screen/method/depth_layers.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// The input "depth_layers": several view depths a texel, metres, the far plane's where a sample is empty.
/// Surfaces are those of the G-buffer: cut-outs have their holes, and both sides of a wall are drawn.
class DepthLayerBuffer {
  public:
    /// A GL_TEXTURE_2D_ARRAY of four samples a texel, or of two or one where no more are asked for. It is
    /// drawn unless it was drawn last: only one is kept, since sixteen samples of 1920x1080 pixels take 133
    /// MB.
    GLuint texture(const GBuffer& gbuffer, const DepthLayers& layers, Mirror mirror);

    /// Draws the scene's surfaces in this order, which does not affect the result. A sample holds the
    /// nearest of the surfaces that it accepts, by blending with the minimum: in one pass without sorting.
    void draw(const GBuffer& gbuffer, const DepthLayers& layers, Mirror mirror,
              std::span<const SceneGeometry::Draw> draws);

    /// Reads the last drawing: a picture for each sample, row 0 at the top.
    std::vector<ImageF> read() const;

    /// Forgets the last drawing, when the G-buffer has changed or the work is to be timed.
    /// Its memory is kept for the next one of the same shape.
    void forget() {
        if (drawn_) drawn_->is_stale = true;
    }

  private:
    struct Drawn {
        DepthLayers layers;
        Mirror mirror = Mirror::none;
        int width = 0, height = 0;
        bool is_stale = false;  ///< of a G-buffer that is no more, or to be drawn again for the clock
        gl::Texture array;
    };
    void allocate(int width, int height, const DepthLayers& layers);
    void blend(const GBuffer& gbuffer, SceneDrawing::Look look);
    void peel(const GBuffer& gbuffer, SceneDrawing::Look look);

    std::optional<Drawn> drawn_;
    SceneDrawing drawing_{"depth layers", "depth_layers.frag"};
};

}  // namespace aoscore
