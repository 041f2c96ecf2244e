#include "metrics/measures.h"
#include "metrics/measures/mean_error.h"

#include <fmt/format.h>

#include <cmath>

namespace aoscore {

MetricValue measure::max_error(const MetricInput& input) {
    require_one_size(input);
    double largest = -1;
    int at_x = 0, at_y = 0;
    for (int y = 0; y < input.truth.height; ++y) {
        for (int x = 0; x < input.truth.width; ++x) {
            if (input.valid.at(x, y) == 0) continue;
            const double error = std::abs(double{input.test.at(x, y)} - double{input.truth.at(x, y)});
            if (!std::isfinite(error)) return undefined(kNotFinite);
            if (error > largest) {
                largest = error;
                at_x = x;
                at_y = y;
            }
        }
    }
    if (largest < 0) return undefined(kNoValidPixel);
    return defined(largest, fmt::format("at pixel {}, {}: truth {:.4g}, test {:.4g}", at_x, at_y,
                                        input.truth.at(at_x, at_y), input.test.at(at_x, at_y)));
}

}  // namespace aoscore
