#include "metrics/measures/angle_errors.h"
#include "metrics/measures/mean_error.h"

#include <numeric>

namespace aoscore {

MetricValue measure::cone_bias(const SignalInput& input) {
    const std::vector<double> differences = angle_differences_deg(input);
    if (differences.empty()) return undefined(kNoValidPixel);
    const double sum = std::accumulate(differences.begin(), differences.end(), 0.0);
    return defined(sum / static_cast<double>(differences.size()));
}

}  // namespace aoscore
