#pragma once

#include "metrics/metric.h"

#include <vector>

namespace aoscore {

/// Errors summed over square blocks of an image, row by row: what is resampled to learn how sure an error or
/// a difference of two is. Neighbouring pixels err alike, distant blocks do not.
struct BlockErrors {
    int side_px = 0;
    int across = 0, down = 0;
    std::vector<double> counts;         ///< valid pixels
    std::vector<double> squared_sums;   ///< of (test - truth)^2
    std::vector<double> absolute_sums;  ///< of |test - truth|
    std::vector<double> signed_sums;    ///< of test - truth
    std::vector<double> variance_sums;  ///< of the truth's squared standard error; empty where not known
};

/// Blocks of 1/24 of the width. Throws sizes_differ.
BlockErrors block_errors(const MetricInput& input);

}  // namespace aoscore
