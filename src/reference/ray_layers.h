#pragma once

#include "core/image.h"

#include <cstdint>
#include <vector>

namespace aoscore {

/// The depths of a pixel that a ray through its centre gathers: the first surface, and of those behind it as
/// many as there is room for, each with the same probability (Brüll, Kern and Grosch, Ray Traced Stochastic
/// Depth Map for Ambient Occlusion, 2024, with Vitter's reservoir, 1985).
struct RayLayers {
    int samples = 1;      ///< depths a pixel, at least 1
    double reach_m = 0;   ///< those behind lie at most so far behind the first, metres; 0: anywhere
    int most_behind = 8;  ///< no more than so many surfaces behind the first are looked at, from the nearest
    std::uint32_t seed = 1;
};

}  // namespace aoscore
