#include "metrics/measures/angle_errors.h"

namespace aoscore {

MetricValue measure::cone_error_mean(const SignalInput& input) {
    return mean_size(angle_differences_deg(input), input);
}

}  // namespace aoscore
