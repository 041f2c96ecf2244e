#include "metrics/measures/power.h"

#include "metrics/measures/power_of_lanes.h"
#include "metrics/measures/wide_lanes.h"

#include <cstddef>

namespace aoscore {

AOSCORE_WIDER_WHERE_POSSIBLE
void raise(std::span<double> values, double exponent) {
    double* value = values.data();
    for (std::size_t i = 0; i < values.size(); ++i) value[i] = power(value[i], exponent);
}

}  // namespace aoscore
