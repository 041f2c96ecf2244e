#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

namespace aoscore {

MetricValue measure::bias(const MetricInput& input) {
    const auto mean = mean_over_valid(input, [](double difference) { return difference; });
    return mean ? defined(*mean) : undefined(kNoValidPixel);
}

}  // namespace aoscore
