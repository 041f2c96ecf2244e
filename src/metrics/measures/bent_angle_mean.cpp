#include "metrics/measures/angle_errors.h"

namespace aoscore {

MetricValue measure::bent_angle_mean(const SignalInput& input) {
    return mean_size(direction_errors_deg(input), input);
}

}  // namespace aoscore
