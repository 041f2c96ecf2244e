#include "metrics/analysis/error_distribution.h"

#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr std::size_t kBins = 201, kSteps = 201;

std::size_t index_of(double position, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

ErrorDistribution error_distribution(const MetricInput& input) {
    require_one_size(input);
    ErrorDistribution result;
    result.histogram.assign(kBins, 0);
    std::vector<double> first_step_that_holds(kSteps + 1, 0);  // The last one: beyond all steps.
    const double bin_width = (result.histogram_high - result.histogram_low) / double{kBins};
    double valid = 0;
    for (std::size_t i = 0; i < input.truth.size(); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        ++result.histogram[index_of(std::floor((error - result.histogram_low) / bin_width), kBins)];
        ++first_step_that_holds[index_of(std::ceil(std::abs(error) / result.cumulative_step), kSteps + 1)];
        ++valid;
    }
    const double count = std::max(valid, 1.0);
    for (double& bin : result.histogram) bin /= count;
    double within = 0;
    for (std::size_t step = 0; step < kSteps; ++step) {
        within += first_step_that_holds[step];
        result.cumulative.push_back(within / count);
    }
    return result;
}

}  // namespace aoscore
