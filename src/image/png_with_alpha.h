#pragma once

#include "core/image.h"

#include <array>
#include <cstdint>
#include <string>

namespace aoscore {

/// Encodes red, green, blue and alpha of 8 bits as PNG.
std::string encode_png_rgba(const Image<std::array<std::uint8_t, 4>>& colours);

}  // namespace aoscore
