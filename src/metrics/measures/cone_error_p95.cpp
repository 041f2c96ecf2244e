#include "metrics/measures/angle_errors.h"

namespace aoscore {

MetricValue measure::cone_error_p95(const SignalInput& input) {
    return size_at_95_percent(angle_differences_deg(input), input);
}

}  // namespace aoscore
