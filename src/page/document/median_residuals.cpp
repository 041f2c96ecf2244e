#include "page/document/median_residuals.h"

#include <algorithm>
#include <cstddef>

namespace aoscore {
namespace {

int predicted_code(int left, int up, int up_left) {
    if (up_left >= std::max(left, up)) return std::min(left, up);
    if (up_left <= std::min(left, up)) return std::max(left, up);
    return left + up - up_left;
}

}  // namespace

std::string median_residuals(const Image<std::uint16_t>& codes, int bytes_a_pixel) {
    const std::size_t size = codes.size();
    std::string bytes(size * static_cast<std::size_t>(bytes_a_pixel), '\0');
    std::size_t i = 0;
    for (int y = 0; y < codes.height; ++y) {
        for (int x = 0; x < codes.width; ++x, ++i) {
            const int left = x > 0 ? codes.pixels[i - 1] : 0;
            const int up = y > 0 ? codes.at(x, y - 1) : 0;
            const int up_left = x > 0 && y > 0 ? codes.at(x - 1, y - 1) : 0;
            const auto residual =
                static_cast<std::uint16_t>(codes.pixels[i] - predicted_code(left, up, up_left));
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

}  // namespace aoscore
