#include "metrics/measures/noise.h"

#include "metrics/measures/mean_error.h"

namespace aoscore {

std::optional<NoiseFloor> noise_floor(const ImageF& standard_error, const Mask& valid) {
    // The standard error is its own difference from nothing.
    const ImageF zero(standard_error.width, standard_error.height);
    const MetricInput input{zero, standard_error, valid};
    const std::optional<double> variance = mean_squared_error(input);
    if (!variance) return std::nullopt;
    const double mean = *mean_over_valid(input, [](double error) { return error; });
    return NoiseFloor{mean, *variance};
}

}  // namespace aoscore
