#pragma once

#include "core/image.h"

namespace aoscore {

/// Distance of every pixel's centre from the nearest marked one, pixels; infinite where none is marked. Exact
/// (Pedro Felzenszwalb, Daniel Huttenlocher, Distance Transforms of Sampled Functions, 2012).
ImageF distance_to(const Mask& marked);

}  // namespace aoscore
