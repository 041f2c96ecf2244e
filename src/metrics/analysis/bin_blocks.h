#pragma once

#include "metrics/analysis/pixel_divisions.h"
#include "metrics/metric.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// Errors of the pixels in one bin of a division, summed over the blocks of BlockGrid, which are resampled
/// for intervals.
struct BinBlocks {
    std::vector<double> counts;       ///< pixels of the bin
    std::vector<double> signed_sums;  ///< of test - truth
};

/// Sums the errors of a bin, counted from 0. Throws sizes_differ.
BinBlocks bin_blocks(const MetricInput& input, const PixelDivision& division, std::size_t bin);

}  // namespace aoscore
