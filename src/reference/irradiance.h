#pragma once

#include "core/image.h"
#include "core/sky.h"
#include "scene/camera.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>

namespace aoscore {

/// Ray-traced irradiance of every pixel's surface over pi: 1 on an open surface where all radiance is 1; 0
/// without surface. Two independent estimates, each from half of the rays, so that an error can be told
/// without their noise: their product with it has the right mean.
struct Irradiance {
    std::array<ImageF, 2> halves;
};

/// Traces it under a sky that whatever lies within `radius_m` of a surface hides. The same picture for any
/// thread count. Throws usage_error for fewer than two `samples` a pixel or an odd number,
/// interrupted_error on Ctrl-C.
Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Sky& sky, double radius_m,
                            int samples, std::uint64_t seed);

}  // namespace aoscore
