#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

#include <cmath>

namespace aoscore {

MetricValue measure::mae(const MetricInput& input) {
    const auto mean = mean_over_valid(input, [](double difference) { return std::abs(difference); });
    return mean ? defined(*mean) : undefined(kNoValidPixel);
}

}  // namespace aoscore
