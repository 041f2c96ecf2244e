#pragma once

#include "core/image.h"

#include <cstdint>

namespace aoscore {

/// A truth with its two halves, and a test image, like visibility: slopes, edges and noise.
struct MadeUpPair {
    ImageF first_half, second_half, truth, test;
    MadeUpPair(int width, int height, std::uint64_t seed);
};

}  // namespace aoscore
