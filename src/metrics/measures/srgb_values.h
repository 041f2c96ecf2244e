#pragma once

#include "metrics/measures/power_of_lanes.h"

#include <span>

namespace aoscore {
namespace lanes {

/// take_srgb_off() of one value, for loops that are built for wide registers.
[[gnu::always_inline]] inline double linear_from_srgb(double value) {
    const double line = value * (1 / 12.92), curve = to_the_2_4((value + 0.055) * (1 / 1.055));
    return value <= 0.04045 ? line : curve;
}

}  // namespace lanes

/// Removes the curve of sRGB (IEC 61966-2-1, 1999) from values in [0,1], like linear_from_srgb() of
/// core/srgb.h to a relative 1e-13, but several times as fast.
void take_srgb_off(std::span<double> values);
/// The inverse of take_srgb_off(), like srgb_from_linear().
void put_srgb_on(std::span<double> values);

}  // namespace aoscore
