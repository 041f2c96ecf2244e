#pragma once

#include "core/image.h"
#include "metrics/metric.h"

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

/// Whether anything is known of the truth's noise.
inline bool knows_noise(const MetricInput& input) {
    return input.halves != nullptr || input.standard_error != nullptr;
}

/// The variance of the truth's noise at pixel `i`, of which only means over many pixels are meant: from its
/// two halves, where it has them, else its squared standard error. That of the halves is without bias
/// whatever the rays, a standard error from few rays is not. knows_noise() must hold.
inline double noise_variance(const MetricInput& input, std::size_t i) {
    const double noise =
        input.halves != nullptr
            ? (double{input.halves->first.pixels[i]} - double{input.halves->second.pixels[i]}) / 2
            : double{input.standard_error->pixels[i]};
    return noise * noise;
}

/// Its mean over the valid pixels; empty where nothing is known or no pixel is valid.
std::optional<double> mean_noise_variance(const MetricInput& input);

}  // namespace aoscore
