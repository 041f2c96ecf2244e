#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <fmt/format.h>

#include <cmath>

namespace aoscore {

// The noise of the truth is independent of the test image, so that it adds its mean variance to the expected
// square.
MetricValue measure::rmse_debiased(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    if (!mse) return undefined(kNoValidPixel);
    if (!knows_noise(input)) return undefined("the truth's standard error is not known");
    const double variance = *mean_noise_variance(input);
    if (!std::isfinite(*mse) || !std::isfinite(variance)) return undefined(kNotFinite);
    if (*mse < variance) {
        return defined(0, fmt::format("below the truth's noise floor of {:.3g}", std::sqrt(variance)));
    }
    return defined(std::sqrt(*mse - variance));
}

}  // namespace aoscore
