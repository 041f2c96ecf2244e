#pragma once

#include "core/image.h"

#include <cstdint>
#include <string>

namespace aoscore {

/// What is left of an image's codes after each is predicted from its left, upper and upper left neighbours (0
/// outside) by the median edge detector (Weinberger, Seroussi, Sapiro, The LOCO-I lossless image compression
/// algorithm, 2000), modulo 2^8 or 2^16; `bytes_a_pixel` is 1 or 2. Of two bytes all high ones come first,
/// after residuals 0, -1, 1, -2, … became 0, 1, 2, 3, …
std::string median_residuals(const Image<std::uint16_t>& codes, int bytes_a_pixel);

}  // namespace aoscore
