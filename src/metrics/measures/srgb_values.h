#pragma once

#include <span>

namespace aoscore {

/// The curve of sRGB (IEC 61966-2-1, 1999) taken off many values in [0,1]: as linear_from_srgb() of
/// core/srgb.h to a relative 1e-13, and several times as fast.
void take_srgb_off(std::span<double> values);
/// Its inverse, as srgb_from_linear().
void put_srgb_on(std::span<double> values);

}  // namespace aoscore
