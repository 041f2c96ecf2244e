#include "page/pictures/quantised_image.h"

#include "page/document/deflate.h"
#include "page/document/dense_text.h"
#include "page/document/median_residuals.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace aoscore {
namespace {

Image<std::uint16_t> codes_of(const ImageF& image, const QuantisedImage& scale) {
    const int none = scale.bytes == 1 ? kLevelsOfOneByte : kLevelsOfTwoBytes;
    Image<std::uint16_t> codes(image.width, image.height);
    std::transform(image.pixels.begin(), image.pixels.end(), codes.pixels.begin(), [&](float value) {
        const double code =
            std::isfinite(value) ? std::round((double{value} - scale.low) / scale.step) : none;
        return static_cast<std::uint16_t>(code);
    });
    return codes;
}

}  // namespace

QuantisedImage scale_for(const ImageF& image, double low, double high, int levels) {
    assert(levels >= 2 && levels <= kLevelsOfTwoBytes);
    for (const float value : image.pixels) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, double{value});
        high = std::max(high, double{value});
    }
    QuantisedImage scale{image.width, image.height, low, 0, levels <= kLevelsOfOneByte ? 1 : 2, {}};
    scale.step = high > low ? (high - low) / (levels - 1) : 1;
    return scale;
}

QuantisedImage quantise(const ImageF& image, double low, double high, int levels) {
    QuantisedImage result = scale_for(image, low, high, levels);
    // Residuals are mostly noise, with runs of zeros where all is open: entropy coding and run lengths
    // compress them almost as well as a search for repetitions would, and several times as fast.
    result.data = dense_text(deflated(median_residuals(codes_of(image, result), result.bytes), 1, Z_RLE));
    return result;
}

}  // namespace aoscore
