#include "metrics/measures/srgb_values.h"

#include "metrics/measures/power.h"

#include <cstddef>
#include <vector>

namespace aoscore {

void take_srgb_off(std::span<double> values) {
    std::vector<double> curved(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) curved[i] = (values[i] + 0.055) / 1.055;
    raise(curved, 2.4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = values[i] <= 0.04045 ? values[i] / 12.92 : curved[i];
}

void put_srgb_on(std::span<double> values) {
    std::vector<double> curved(values.begin(), values.end());
    raise(curved, 1 / 2.4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = values[i] <= 0.0031308 ? values[i] * 12.92 : 1.055 * curved[i] - 0.055;
}

}  // namespace aoscore
