#include "metrics/measures/noise.h"

#include "metrics/measures/mean_error.h"

namespace aoscore {

std::optional<NoiseFloor> noise_floor(const ImageF& standard_error, const Mask& valid) {
    // The squared standard error is a squared difference from 0.
    const ImageF zero(standard_error.width, standard_error.height);
    const MetricInput input{zero, standard_error, valid};
    const std::optional<double> variance = mean_squared_error(input);
    if (!variance) return std::nullopt;
    const double mean = *mean_over_valid(input, [](double error) { return error; });
    return NoiseFloor{mean, *variance};
}

std::optional<double> mean_noise_variance(const MetricInput& input) {
    if (input.halves != nullptr) {
        // Half their difference is the error of one against their mean.
        const MetricInput apart{input.truth, input.halves->first, input.valid};
        return mean_squared_error(apart);
    }
    if (input.standard_error == nullptr) return std::nullopt;
    const std::optional<NoiseFloor> floor = noise_floor(*input.standard_error, input.valid);
    return floor ? std::optional(floor->mean_variance) : std::nullopt;
}

}  // namespace aoscore
