#pragma once

#include <cmath>

namespace aoscore {

/// The curve of sRGB (IEC 61966-2-1, 1999), for values in [0,1].
inline double linear_from_srgb(double coded) {
    return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}
/// The inverse of linear_from_srgb().
inline double srgb_from_linear(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace aoscore
