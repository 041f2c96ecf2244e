#include "page/pictures/quantised_image.h"

#include "page/document/base64.h"
#include "page/document/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace aoscore {
namespace {

int predicted(int left, int up, int up_left) {
    if (up_left >= std::max(left, up)) return std::min(left, up);
    if (up_left <= std::min(left, up)) return std::max(left, up);
    return left + up - up_left;
}

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

std::string residuals(const Image<std::uint16_t>& codes, int bytes_a_pixel) {
    const std::size_t size = codes.size();
    std::string bytes(size * static_cast<std::size_t>(bytes_a_pixel), '\0');
    std::size_t i = 0;
    for (int y = 0; y < codes.height; ++y) {
        for (int x = 0; x < codes.width; ++x, ++i) {
            const int left = x > 0 ? codes.pixels[i - 1] : 0;
            const int up = y > 0 ? codes.at(x, y - 1) : 0;
            const int up_left = x > 0 && y > 0 ? codes.at(x - 1, y - 1) : 0;
            const auto residual = static_cast<std::uint16_t>(codes.pixels[i] - predicted(left, up, up_left));
            if (bytes_a_pixel == 1) {
                bytes[i] = static_cast<char>(residual);
            } else {
                const auto folded =
                    static_cast<std::uint16_t>((residual << 1U) ^ (residual >> 15U != 0 ? 0xffffU : 0U));
                bytes[i] = static_cast<char>(folded >> 8U);
                bytes[size + i] = static_cast<char>(folded);
            }
        }
    }
    return bytes;
}

}  // namespace

QuantisedImage quantise(const ImageF& image, double low, double high, int levels) {
    assert(levels >= 2 && levels <= kLevelsOfTwoBytes);
    for (const float value : image.pixels) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, double{value});
        high = std::max(high, double{value});
    }
    QuantisedImage result{image.width, image.height, low, 0, levels <= kLevelsOfOneByte ? 1 : 2, {}};
    result.step = high > low ? (high - low) / (levels - 1) : 1;
    // Residuals are mostly noise, with runs of zeros where all is open: entropy coding and run lengths
    // compress them almost as well as a search for repetitions would, and several times as fast.
    result.data = base64(deflated(residuals(codes_of(image, result), result.bytes), 1, Z_RLE));
    return result;
}

}  // namespace aoscore
