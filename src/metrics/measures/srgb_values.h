#pragma once

#include <span>

namespace aoscore {

/// Removes the curve of sRGB (IEC 61966-2-1, 1999) from values in [0,1], like linear_from_srgb() of
/// core/srgb.h to a relative 1e-13, but several times as fast.
void take_srgb_off(std::span<double> values);
/// The inverse of take_srgb_off(), like srgb_from_linear().
void put_srgb_on(std::span<double> values);

}  // namespace aoscore
