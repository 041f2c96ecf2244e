#include "scene/gltf/colour_filter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace aoscore::gltf {
namespace {

template <class T>
T scaled(int value, float scale) {
    const float rounded = std::round(static_cast<float>(value) * scale);
    return static_cast<T>(std::clamp(rounded, 0.0f, static_cast<float>(std::numeric_limits<T>::max())));
}

template <class T>
void decode(std::string& bytes) {
    using Signed = std::make_signed_t<T>;
    for (std::size_t at = 0; at + 4 * sizeof(T) <= bytes.size(); at += 4 * sizeof(T)) {
        T in[4];
        std::memcpy(in, &bytes[at], sizeof in);
        const int most = (1 << std::bit_width(in[3])) - 1;
        const int y = in[0], co = static_cast<Signed>(in[1]), cg = static_cast<Signed>(in[2]);
        const int low_bits = in[3] & (most >> 1);
        const int alpha = (low_bits << 1) | (low_bits & 1);
        const float scale =
            most > 0 ? static_cast<float>(std::numeric_limits<T>::max()) / static_cast<float>(most) : 0.0f;
        const T out[4] = {scaled<T>(y + co - cg, scale), scaled<T>(y + cg, scale),
                          scaled<T>(y - co - cg, scale), scaled<T>(alpha, scale)};
        std::memcpy(&bytes[at], out, sizeof out);
    }
}

}  // namespace

void decode_colours(std::string& bytes, std::size_t component_bytes) {
    if (component_bytes == 1) {
        decode<std::uint8_t>(bytes);
    } else {
        decode<std::uint16_t>(bytes);
    }
}

}  // namespace aoscore::gltf
