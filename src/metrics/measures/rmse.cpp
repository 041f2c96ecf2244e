#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

#include <cmath>

namespace aoscore {

MetricValue measure::rmse(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    return mse ? defined(std::sqrt(*mse)) : undefined(kNoValidPixel);
}

}  // namespace aoscore
