#pragma once

#include "metrics/measures/structural_similarity.h"
#include "metrics/metric.h"

namespace aoscore {

/// MS-SSIM's scales: the image, and four times the image before at half the size.
inline constexpr int kSimilarityScales = 5;
/// The shorter side of the smallest image whose coarsest scale has a window.
inline constexpr int kSmallestSide_px = (2 * kSsimBorder_px + 1) << (kSimilarityScales - 1);

/// The squares by which MS-SSIM sums. They are as wide as the coarsest window: smaller ones would not be
/// independent.
BlockGrid similarity_squares(const Mask& valid);

/// The similarity of a pair at full size, which SSIM and MS-SSIM have in common.
struct FinestSimilarity {
    SsimSums by_block;   ///< by BlockGrid
    SsimSums by_square;  ///< by similarity_squares()
};

/// Measures it, or takes it from `input.shared`, where an earlier metric has left it.
FinestSimilarity finest_similarity(const MetricInput& input);

}  // namespace aoscore
