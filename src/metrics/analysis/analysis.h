#pragma once

#include "metrics/analysis/best_fit.h"
#include "metrics/analysis/error_distribution.h"
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

/// Where and how a test image is wrong, beside how much (the metrics).
struct ErrorAnalysis {
    std::map<std::string, Interval> intervals;  ///< 95 % confidence, by id; see confidence_intervals()
    BestFit fit;                                ///< strength and exponent that would suit it best
    MaskSummary missing;                        ///< brighter than the truth beyond threshold and noise
    MaskSummary false_occlusion;                ///< darker
    std::vector<ErrorRegion> regions;           ///< worst connected pieces of both masks
    std::vector<Split> splits;                  ///< error by property of the pixel
    ErrorDistribution distribution;
    std::optional<double> tile_pattern;  ///< see tile_pattern()
    /// How far each metric may lie from its value against a truth without noise, by id (see truth_noise()):
    /// half the width of an interval that holds it with 95 % confidence. Empty where the truth has no halves.
    std::map<std::string, double> truth_noise;
    BlockErrors blocks;  ///< what the intervals are made of; pairs with those of other tests of the truth
};

/// SSIM, MS-SSIM and FLIP have intervals where evaluate() left their sums in `input.maps`. `mask_threshold`
/// in visibility; `seed` of the resampling. Empty without a valid pixel or where a valid one is NaN or
/// infinite. `divisions` are pixel_divisions() of mask and facts, where other tests need them as well; null:
/// they are made. Throws sizes_differ.
std::optional<ErrorAnalysis> analyse(const MetricInput& input, const PixelFacts& facts, double mask_threshold,
                                     std::uint64_t seed,
                                     const std::vector<PixelDivision>* divisions = nullptr);

}  // namespace aoscore
