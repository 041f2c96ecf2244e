#include "page/live/live_packing.h"

#include "page/document/deflate.h"
#include "page/document/dense_text.h"
#include "page/document/median_residuals.h"

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

struct OctahedralCodes {
    Image<std::uint16_t> first, second;
};

OctahedralCodes octahedral_codes(const Image<glm::vec3>& normals) {
    OctahedralCodes codes{Image<std::uint16_t>(normals.width, normals.height),
                          Image<std::uint16_t>(normals.width, normals.height)};
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 n(normals.pixels[i]);
        const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
        double x = n.x / sum, y = n.y / sum;
        if (n.z < 0) {
            const double old_x = x;
            x = (1 - std::abs(y)) * (old_x < 0 ? -1 : 1);
            y = (1 - std::abs(old_x)) * (y < 0 ? -1 : 1);
        }
        codes.first.pixels[i] = code_of(x);
        codes.second.pixels[i] = code_of(y);
    }
    return codes;
}

/// Both codes of each pixel, the lower byte first.
std::string bytes_of(const OctahedralCodes& codes) {
    std::string bytes;
    bytes.reserve(4 * codes.first.size());
    for (std::size_t i = 0; i < codes.first.size(); ++i) {
        for (const std::uint16_t code : {codes.first.pixels[i], codes.second.pixels[i]}) {
            bytes += static_cast<char>(code);
            bytes += static_cast<char>(code >> 8U);
        }
    }
    return bytes;
}

}  // namespace

std::string pack_text(std::string_view text) {
    return dense_text(deflated(text, 9, Z_DEFAULT_STRATEGY));
}

std::string folded_planes(std::span<const std::uint32_t> residuals) {
    const std::size_t size = residuals.size();
    std::string bytes(4 * size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint32_t value = folded(residuals[i]);
        for (std::size_t k = 0; k < 4; ++k) bytes[k * size + i] = static_cast<char>(value >> (24 - 8 * k));
    }
    return bytes;
}

std::string pack_integers(std::span<const std::uint32_t> values, int width) {
    const std::size_t size = values.size(), row = static_cast<std::size_t>(width);
    std::vector<std::uint32_t> residuals(size);
    for (std::size_t i = 0; i < size; ++i) {
        const bool has_left = i % row != 0, has_up = i >= row;
        const std::uint32_t left = has_left ? values[i - 1] : 0U, up = has_up ? values[i - row] : 0U;
        const std::uint32_t up_left = has_left && has_up ? values[i - row - 1] : 0U;
        residuals[i] = values[i] - (left + up - up_left);
    }
    return dense_text(deflated(folded_planes(residuals), 6, Z_FILTERED));
}

PackedInput pack_floats(const ImageF& image) {
    std::vector<std::uint32_t> bits;
    bits.reserve(image.size());
    for (const float value : image.pixels) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return {"floats", pack_integers(bits, image.width)};
}

PackedInput pack_normals(const Image<glm::vec3>& normals) {
    const OctahedralCodes codes = octahedral_codes(normals);
    const std::string plain = bytes_of(codes);
    const std::string residuals = median_residuals(codes.first, 2) + median_residuals(codes.second, 2);
    const auto quick_size = [](const std::string& bytes) {
        return deflated(bytes, 1, Z_DEFAULT_STRATEGY).size();
    };
    const bool predict = quick_size(residuals) < quick_size(plain);
    return {predict ? "predicted normals" : "normals",
            dense_text(deflated(predict ? residuals : plain, 6, Z_DEFAULT_STRATEGY))};
}

}  // namespace aoscore
