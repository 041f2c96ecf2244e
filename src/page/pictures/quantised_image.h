#pragma once

#include "core/image.h"

#include <string>

namespace aoscore {

/// As many numbers as one byte, or two, can tell apart beside "no number".
inline constexpr int kLevelsOfOneByte = 255, kLevelsOfTwoBytes = 65535;

/// An image as the page keeps it: value = low + step * code, off by at most half a step. The largest code,
/// 255 or 65535, stands where there is no finite number.
///
/// `data` is, in base64, the zlib stream (RFC 1950) of what is left after each code is predicted from its
/// left, upper and upper left neighbours (0 outside) by the median edge detector (Weinberger, Seroussi,
/// Sapiro, The LOCO-I lossless image compression algorithm, 2000), modulo 2^8 or 2^16. Two bytes are kept
/// apart, all high ones first, after residuals 0, -1, 1, -2, … became 0, 1, 2, 3, …
struct QuantisedImage {
    int width = 0, height = 0;
    double low = 0, step = 0;
    int bytes = 1;  ///< a pixel
    std::string data;

    bool empty() const { return data.empty(); }
};

/// `levels` (2 to kLevelsOfTwoBytes) numbers over the range [low, high], which becomes wider where values lie
/// outside.
QuantisedImage quantise(const ImageF& image, double low, double high, int levels);

}  // namespace aoscore
