#pragma once

#include "core/image.h"

namespace aoscore {

/// One of the surfaces that lie behind one another at each pixel. Of those of one pixel, front to back, all
/// depth layers that are rasterised can be gathered without the scene (shaders/gbuffer/gathered_layers.frag),
/// except where a coin depends on how a place changes over its triangle.
struct SurfaceLayer {
    ImageF depth_m;  ///< view depth; negative where a face is seen from behind; the far plane's where none is
    /// The drawn triangle's number of 32 bits, on which the coins depend: its lower and upper half.
    ImageF triangle_low, triangle_high;
};

}  // namespace aoscore
