#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

namespace aoscore {

MetricValue measure::bias(const MetricInput& input) {
    const std::optional<double> mean = mean_error(input);
    return mean ? defined(*mean) : undefined(kNoValidPixel);
}

}  // namespace aoscore
