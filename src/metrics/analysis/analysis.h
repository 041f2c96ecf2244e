#pragma once

#include "metrics/analysis/best_fit.h"
#include "metrics/analysis/bin_blocks.h"
#include "metrics/analysis/error_distribution.h"
#include "metrics/analysis/mask_summary.h"
#include "metrics/analysis/occlusion_masks.h"
#include "metrics/analysis/pixel_facts.h"
#include "metrics/analysis/regions.h"
#include "metrics/analysis/splits.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/bootstrap.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The places and kinds of a test image's errors; metrics tell their size.
struct ErrorAnalysis {
    /// 95 % confidence, by id: confidence_intervals(), and ratio_interval() of the masks' mean errors.
    std::map<std::string, Interval> intervals;
    BestFit fit;                       ///< strength and exponent that fit it best
    MaskSummary missing;               ///< brighter than the truth beyond the threshold
    MaskSummary false_occlusion;       ///< darker than the truth beyond it
    std::vector<ErrorRegion> regions;  ///< worst connected pieces of both masks
    std::vector<Split> splits;         ///< error by property of the pixel
    /// Errors on the far side of depth edges; without blocks where depth is unknown.
    BinBlocks behind_edges;
    ErrorDistribution distribution;
    std::optional<double> tile_pattern;  ///< see tile_pattern()
    /// See found_beyond_layer(); empty where the bound was not traced.
    std::optional<double> found_beyond_layer;
    /// The half width of an interval that holds a metric's value against a truth without noise with 95 %
    /// confidence, by id (see truth_noise()); of metrics where the truth has halves, of the masks' areas and
    /// of the mean errors over them (MaskArea::mean_id) where its standard error is known (see MeasuredMask).
    std::map<std::string, double> truth_noise;
    BlockErrors blocks;  ///< source of the intervals; pairs with other tests of the truth
};

/// Analyses a test image. SSIM, MS-SSIM and FLIP have intervals where evaluate() left their sums in
/// `input.maps`. `mask_threshold` is in visibility, `seed` is that of the resampling. Empty without a valid
/// pixel or where a valid one is NaN or infinite. `divisions` are pixel_divisions() of mask and facts, where
/// other tests need them as well; null: analyse() makes them. Throws sizes_differ.
std::optional<ErrorAnalysis> analyse(const MetricInput& input, const PixelFacts& facts, double mask_threshold,
                                     std::uint64_t seed,
                                     const std::vector<PixelDivision>* divisions = nullptr);

}  // namespace aoscore
