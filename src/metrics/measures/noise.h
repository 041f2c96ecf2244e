#pragma once

#include "core/image.h"

#include <cmath>
#include <optional>

namespace aoscore {

/// How much of an error is the truth's own noise.
struct NoiseFloor {
    double mean_standard_error = 0;  ///< mean over valid pixels
    double mean_variance = 0;        ///< mean squared standard error over valid pixels
    /// The RMSE that a perfect method would show.
    double rmse() const { return std::sqrt(mean_variance); }
};

/// Empty without a valid pixel. Throws sizes_differ.
std::optional<NoiseFloor> noise_floor(const ImageF& standard_error, const Mask& valid);

}  // namespace aoscore
