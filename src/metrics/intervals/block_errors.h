#pragma once

#include "metrics/metric.h"

#include <optional>
#include <vector>

namespace aoscore {

struct MaskTotals;

/// Sums over the blocks of BlockGrid for metrics that are means of a map. A metric that was not measured has
/// none.
struct MapSums {
    std::vector<double> ssim_sums;     ///< sums of the index, over the valid pixels inside the border
    std::vector<double> ssim_weights;  ///< the number of those pixels
    std::vector<double> flip_sums;     ///< over the valid pixels
    std::optional<double> ms_ssim;     ///< empty where the picture is too small for an interval
    /// The first-order change of the logarithm of MS-SSIM each time a square of at least 176 pixels is drawn;
    /// their sum is 0 (the influence function; Bradley Efron, The Jackknife, the Bootstrap and Other
    /// Resampling Plans, 1982, chapter 6). These squares are larger than the blocks, since the window of the
    /// coarsest scale is as wide.
    std::vector<double> ms_ssim_influences;
};

/// Errors summed over square blocks of an image, row by row, which are resampled for the intervals of metrics
/// and of their differences. Neighbouring pixels have similar errors, distant blocks do not.
struct BlockErrors {
    int side_px = 0;
    int across = 0, down = 0;
    std::vector<double> counts;         ///< valid pixels
    std::vector<double> squared_sums;   ///< sums of (test - truth)^2
    std::vector<double> absolute_sums;  ///< sums of |test - truth|
    std::vector<double> signed_sums;    ///< sums of test - truth
    std::vector<double> variance_sums;  ///< sums of noise_variance(); empty where unknown
    std::vector<double>
        missing_counts;  ///< sums of BeyondThreshold::share of missing occlusion, see with_masks()
    std::vector<double> false_counts;  ///< the same of false occlusion
    MapSums maps;                      ///< the sums that evaluate() left in the input
};

/// Sums the errors over blocks of 1/24 of the width, without those of the masks. Throws sizes_differ.
BlockErrors block_errors(const MetricInput& input);

/// The same with the masks' sums in `masks`, which are of the same input.
BlockErrors with_masks(BlockErrors blocks, const MaskTotals& masks);

}  // namespace aoscore
