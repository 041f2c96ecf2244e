#include "metrics/measures/noise.h"

#include "metrics/measures/mean_error.h"

namespace aoscore {

std::optional<NoiseFloor> noise_floor(const ImageF& standard_error, const Mask& valid) {
    const DifferenceSums sums = value_sums(standard_error, valid);
    if (sums.count == 0) return std::nullopt;
    return NoiseFloor{sums.signed_sum / sums.count, sums.squared / sums.count};
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
