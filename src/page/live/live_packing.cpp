#include "page/live/live_packing.h"

#include "page/document/base64.h"
#include "page/document/deflate.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

std::uint32_t folded(std::uint32_t residual) {
    return (residual << 1U) ^ (residual >> 31U != 0 ? 0xffffffffU : 0U);
}

std::uint16_t code_of(double component) {
    return static_cast<std::uint16_t>(std::lround((component + 1) * 32767));
}

}  // namespace

std::string pack_text(std::string_view text) {
    return base64(deflated(text, 9, Z_DEFAULT_STRATEGY));
}

std::string pack_integers(std::span<const std::uint32_t> values, int width) {
    const std::size_t size = values.size(), row = static_cast<std::size_t>(width);
    std::string bytes(4 * size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
        const bool has_left = i % row != 0, has_up = i >= row;
        const std::uint32_t left = has_left ? values[i - 1] : 0U, up = has_up ? values[i - row] : 0U;
        const std::uint32_t up_left = has_left && has_up ? values[i - row - 1] : 0U;
        const std::uint32_t residual = folded(values[i] - (left + up - up_left));
        for (std::size_t k = 0; k < 4; ++k) bytes[k * size + i] = static_cast<char>(residual >> (24 - 8 * k));
    }
    return base64(deflated(bytes, 6, Z_FILTERED));
}

std::string pack_floats(const ImageF& image) {
    std::vector<std::uint32_t> bits;
    bits.reserve(image.size());
    for (const float value : image.pixels) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return pack_integers(bits, image.width);
}

std::string pack_normals(const Image<glm::vec3>& normals) {
    std::string bytes;
    bytes.reserve(4 * normals.size());
    for (const glm::vec3& normal : normals.pixels) {
        const glm::dvec3 n(normal);
        const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
        double x = n.x / sum, y = n.y / sum;
        if (n.z < 0) {
            const double old_x = x;
            x = (1 - std::abs(y)) * (old_x < 0 ? -1 : 1);
            y = (1 - std::abs(old_x)) * (y < 0 ? -1 : 1);
        }
        for (const std::uint16_t code : {code_of(x), code_of(y)}) {
            bytes += static_cast<char>(code);
            bytes += static_cast<char>(code >> 8U);
        }
    }
    return base64(deflated(bytes, 6, Z_DEFAULT_STRATEGY));
}

}  // namespace aoscore
