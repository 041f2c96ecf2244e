#include "metrics/analysis/likeness.h"

#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

struct Sums {
    double count = 0, truth = 0, test = 0, truth_squared = 0, test_squared = 0, product = 0;

    // Values of about a half are subtracted, so that flat pictures keep their digits.
    void add(double truth_value, double test_value) {
        const double a = truth_value - 0.5, b = test_value - 0.5;
        ++count;
        truth += a;
        test += b;
        truth_squared += a * a;
        test_squared += b * b;
        product += a * b;
    }
};

}  // namespace

std::optional<Likeness> likeness(const MetricInput& input) {
    require_one_size(input);
    Sums s;
    for (std::size_t i = 0; i < input.truth.size(); ++i) {
        const double truth = static_cast<double>(input.truth.pixels[i]);
        const double test = static_cast<double>(input.test.pixels[i]);
        if (input.valid.pixels[i] != 0 && std::isfinite(truth) && std::isfinite(test)) s.add(truth, test);
    }
    if (s.count < 2) return std::nullopt;
    const double of_truth = s.truth_squared - s.truth * s.truth / s.count;
    const double of_test = s.test_squared - s.test * s.test / s.count;
    // Rounding gives constant pictures less than this.
    const double least = 1e-12 * s.count;
    if (!(of_truth > least) || !(of_test > least)) return std::nullopt;
    const double both = s.product - s.truth * s.test / s.count;
    return Likeness{both / std::sqrt(of_truth * of_test),
                    std::sqrt(std::max(s.truth_squared + s.test_squared - 2 * s.product, 0.0) / s.count)};
}

}  // namespace aoscore
