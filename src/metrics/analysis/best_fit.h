#pragma once

#include "metrics/metric.h"

#include <optional>
#include <vector>

namespace aoscore {

/// The strength s and exponent k that bring a test image V nearest to the truth by V' = max(1 - s(1-V), 0)^k,
/// clamped to [0,1], and its error after that, which separates a dark or pale calibration from a wrong shape.
/// The fit is never worse than the image itself, where that lies in [0,1].
struct BestFit {
    double strength = 1;                  ///< s in [0, 4]
    double exponent = 1;                  ///< k in [1/8, 8]
    double rmse = 0;                      ///< of V'
    std::optional<double> rmse_debiased;  ///< that of V'; empty without the truth's standard error
    double bias = 0;                      ///< of V'
    std::vector<double> squared_sums;     ///< of V' - truth, squared, over the blocks of BlockGrid
};

/// Empty without a valid pixel. Throws sizes_differ.
std::optional<BestFit> best_fit(const MetricInput& input);

}  // namespace aoscore
