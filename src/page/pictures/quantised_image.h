#pragma once

#include "core/image.h"

#include <string>

namespace aoscore {

/// The number of values that one byte, or two, can hold beside NaN.
inline constexpr int kLevelsOfOneByte = 255, kLevelsOfTwoBytes = 65535;

/// An image quantised for a page: value = low + step * code, with an error of at most half a step. The
/// largest code, 255 or 65535, stands where there is no finite number.
///
/// `data` is the base64 of a zlib stream (RFC 1950) of residuals, after each code is predicted from its left,
/// upper and upper left neighbours (0 outside) by the median edge detector (Weinberger, Seroussi, Sapiro, The
/// LOCO-I lossless image compression algorithm, 2000), modulo 2^8 or 2^16. Of two bytes all high ones come
/// first, after residuals 0, -1, 1, -2, … became 0, 1, 2, 3, …
struct QuantisedImage {
    int width = 0, height = 0;
    double low = 0, step = 0;
    int bytes = 1;  ///< bytes a pixel
    std::string data;

    bool empty() const { return data.empty(); }
};

/// Quantises an image to `levels` (2 to kLevelsOfTwoBytes) values over [low, high], which becomes wider where
/// values lie outside.
QuantisedImage quantise(const ImageF& image, double low, double high, int levels);

}  // namespace aoscore
