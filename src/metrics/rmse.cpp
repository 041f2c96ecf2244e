#include "metrics/mean_error.h"
#include "metrics/measures.h"

#include <cmath>

namespace aoscore {

MetricValue measure::rmse(const MetricInput& input) {
    const std::optional<double> mse = mean_squared_error(input);
    return mse ? defined(std::sqrt(*mse)) : undefined(kNoValidPixel);
}

}  // namespace aoscore
