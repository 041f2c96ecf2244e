#pragma once

#include "metrics/metric.h"

#include <vector>

namespace aoscore {

/// How the errors (test - truth) of the valid pixels are spread: bins and steps are the same for all images,
/// so that curves of several methods can lie over one another.
struct ErrorDistribution {
    double histogram_low = -1.005;  ///< lower end of the first bin: the middle ones are at -1, -0.99, …, 1
    double histogram_high = 1.005;  ///< upper end of the last bin
    /// Share of the valid pixels in each of 201 equal bins; what lies beyond the ends is in the outermost.
    std::vector<double> histogram;
    double cumulative_step = 0.005;
    /// Share of the valid pixels whose |error| is at most i steps, for i = 0 to 200.
    std::vector<double> cumulative;
};

/// All shares are 0 without a valid pixel. Throws sizes_differ.
ErrorDistribution error_distribution(const MetricInput& input);

}  // namespace aoscore
