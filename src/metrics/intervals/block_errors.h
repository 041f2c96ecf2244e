#pragma once

#include "metrics/analysis/occlusion_masks.h"
#include "metrics/metric.h"

#include <optional>
#include <vector>

namespace aoscore {

/// What the metrics that are means of a map are made of, summed over the blocks of BlockGrid. Empty where a
/// metric was not measured.
struct MapSums {
    std::vector<double> ssim_sums;     ///< of the index, over the valid pixels inside the border
    std::vector<double> ssim_weights;  ///< how many of these there are
    std::vector<double> flip_sums;     ///< over the valid pixels
    std::optional<double> ms_ssim;     ///< empty where the picture is too small for an interval
    /// By how much, to first order, a square of at least 176 pixels moves the logarithm of MS-SSIM each time
    /// it is drawn: all of them add up to 0 (the influence function; Bradley Efron, The Jackknife, the
    /// Bootstrap and Other Resampling Plans, 1982, chapter 6). Larger squares than the others, for the window
    /// of the coarsest scale is as wide.
    std::vector<double> ms_ssim_influences;
};

/// Errors summed over square blocks of an image, row by row: what is resampled to learn how sure a metric or
/// a difference of two is. Neighbouring pixels err alike, distant blocks do not.
struct BlockErrors {
    int side_px = 0;
    int across = 0, down = 0;
    std::vector<double> counts;          ///< valid pixels
    std::vector<double> squared_sums;    ///< of (test - truth)^2
    std::vector<double> absolute_sums;   ///< of |test - truth|
    std::vector<double> signed_sums;     ///< of test - truth
    std::vector<double> variance_sums;   ///< of noise_variance(); empty where not known
    std::vector<double> missing_counts;  ///< pixels of missing occlusion
    std::vector<double> false_counts;    ///< pixels of false occlusion
    MapSums maps;                        ///< as evaluate() left them in the input
};

/// Blocks of 1/24 of the width. Throws sizes_differ.
BlockErrors block_errors(const MetricInput& input, const OcclusionMasks& masks);

}  // namespace aoscore
