#pragma once

#include "core/image.h"

#include <cstddef>

namespace aoscore {

/// The mean over the valid pixels; 0 without any. Both images have one size.
inline double mean_over(const ImageF& image, const Mask& valid) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (valid.pixels[i] == 0) continue;
        sum += static_cast<double>(image.pixels[i]);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace aoscore
