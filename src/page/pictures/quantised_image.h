#pragma once

#include "core/image.h"

#include <string>

namespace aoscore {

/// The number of values that one byte, or two, can hold beside NaN.
inline constexpr int kLevelsOfOneByte = 255, kLevelsOfTwoBytes = 65535;

/// An image quantised for a page: value = low + step * code, with an error of at most half a step. The
/// largest code, 255 or 65535, stands where there is no finite number.
///
/// `data` is dense_text() of a zlib stream (RFC 1950) of the codes' residuals (median_residuals.h).
struct QuantisedImage {
    int width = 0, height = 0;
    double low = 0, step = 0;
    int bytes = 1;  ///< bytes a pixel
    std::string data;

    bool empty() const { return data.empty(); }
};

/// The scale that quantise() gives an image, without data.
QuantisedImage scale_for(const ImageF& image, double low, double high, int levels);

/// Quantises an image to `levels` (2 to kLevelsOfTwoBytes) values over [low, high], which becomes wider where
/// values lie outside.
QuantisedImage quantise(const ImageF& image, double low, double high, int levels);

}  // namespace aoscore
