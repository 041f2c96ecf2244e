#pragma once

#include "metrics/metric.h"

#include <vector>

namespace aoscore {

/// The distribution of errors (test - truth) over the valid pixels: bins and steps are the same for all
/// images, so that curves of several methods can lie over one another.
struct ErrorDistribution {
    double histogram_low = -1.005;  ///< lower end of the first bin: the middle ones are at -1, -0.99, …, 1
    double histogram_high = 1.005;  ///< upper end of the last bin
    /// The share of valid pixels in each of 201 equal bins; errors beyond the ends are in the outermost.
    std::vector<double> histogram;
    double cumulative_step = 0.005;
    /// Share of the pixels whose |error| is at most i steps, i = 0 to 200, noise taken off: see ErrorCurve.
    std::vector<double> cumulative;
};

/// All shares are 0 without a valid pixel. Throws sizes_differ.
ErrorDistribution error_distribution(const MetricInput& input);

}  // namespace aoscore
