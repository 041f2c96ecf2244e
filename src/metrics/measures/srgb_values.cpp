#include "metrics/measures/srgb_values.h"

#include "metrics/measures/wide_lanes.h"

#include <cstddef>

namespace aoscore {

AOSCORE_WIDER_WHERE_POSSIBLE
void take_srgb_off(std::span<double> values) {
    double* value = values.data();
    for (std::size_t i = 0; i < values.size(); ++i) value[i] = lanes::linear_from_srgb(value[i]);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void put_srgb_on(std::span<double> values) {
    double* value = values.data();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double v = value[i];
        const double line = v * 12.92, curve = 1.055 * power(v, 1 / 2.4) - 0.055;
        value[i] = v <= 0.0031308 ? line : curve;
    }
}

}  // namespace aoscore
