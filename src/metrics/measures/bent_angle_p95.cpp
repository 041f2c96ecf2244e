#include "metrics/measures/angle_errors.h"

namespace aoscore {

MetricValue measure::bent_angle_p95(const SignalInput& input) {
    return size_at_95_percent(direction_errors_deg(input), input);
}

}  // namespace aoscore
