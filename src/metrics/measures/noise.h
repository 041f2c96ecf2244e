#pragma once

#include "core/image.h"
#include "metrics/metric.h"

#include <cmath>
#include <optional>

namespace aoscore {

/// The part of an error that is the truth's own noise.
struct NoiseFloor {
    double mean_standard_error = 0;  ///< mean over valid pixels
    double mean_variance = 0;        ///< mean squared standard error over valid pixels
    /// The RMSE that a perfect method would show.
    double rmse() const { return std::sqrt(mean_variance); }
};

/// Computes it; empty without a valid pixel. Throws sizes_differ.
std::optional<NoiseFloor> noise_floor(const ImageF& standard_error, const Mask& valid);

/// Whether the truth's noise is known.
inline bool knows_noise(const MetricInput& input) {
    return input.halves != nullptr || input.standard_error != nullptr;
}

/// The variance of the truth's noise at pixel `i`, to be averaged over many pixels: from its two halves,
/// where it has them, else the squared standard error. The halves give no bias for any number of rays, a
/// standard error from few rays does. knows_noise() must hold.
inline double noise_variance(const MetricInput& input, std::size_t i) {
    const double noise =
        input.halves != nullptr
            ? (double{input.halves->first.pixels[i]} - double{input.halves->second.pixels[i]}) / 2
            : double{input.standard_error->pixels[i]};
    return noise * noise;
}

/// The mean of noise_variance() over the valid pixels; empty where it is unknown or no pixel is valid.
std::optional<double> mean_noise_variance(const MetricInput& input);

}  // namespace aoscore
