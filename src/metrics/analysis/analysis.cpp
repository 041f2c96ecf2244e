#include "metrics/analysis/analysis.h"

#include "metrics/analysis/beyond_layer.h"
#include "metrics/analysis/measured_masks.h"
#include "metrics/analysis/tile_pattern.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/intervals/truth_noise.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace aoscore {
namespace {

/// A threshold that nothing is beyond: the masks are summed apart, and against a half not at all.
constexpr double kNoMask = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<ErrorAnalysis> analyse(const MetricInput& input, const PixelFacts& facts, double mask_threshold,
                                     std::uint64_t seed, const std::vector<PixelDivision>* divisions) {
    const std::optional<BestFit> fit = best_fit(input);
    if (!fit) return std::nullopt;
    ErrorAnalysis analysis;
    analysis.fit = *fit;
    const OcclusionMasks masks = occlusion_masks(input, mask_threshold);
    MaskTotals totals = mask_totals(input, mask_threshold, facts.causes);
    MeasuredMasks measured = measured_masks(input, totals, mask_threshold, facts.causes);
    analysis.missing = std::move(measured.missing.summary);
    analysis.false_occlusion = std::move(measured.false_occlusion.summary);
    analysis.regions = worst_regions(masks, input, facts.causes);
    const std::vector<PixelDivision> own =
        divisions != nullptr ? std::vector<PixelDivision>() : pixel_divisions(input.valid, facts);
    if (divisions == nullptr) divisions = &own;
    analysis.splits = error_splits(input, facts, *divisions);
    const auto sides = std::ranges::find(*divisions, "edge_side", &PixelDivision::id);
    if (sides != divisions->end()) analysis.behind_edges = bin_blocks(input, *sides, 0);
    analysis.distribution = error_distribution(input);
    analysis.tile_pattern = tile_pattern(input);
    if (facts.one_layer != nullptr) analysis.found_beyond_layer = found_beyond_layer(input, *facts.one_layer);
    analysis.blocks = block_errors(input, kNoMask);
    analysis.blocks.missing_counts = std::move(totals.missing.blocks);
    analysis.blocks.false_counts = std::move(totals.false_occlusion.blocks);
    if (input.halves != nullptr) {
        const BlockErrors first = block_errors(against_half(input, 0), kNoMask);
        const BlockErrors second = block_errors(against_half(input, 1), kNoMask);
        analysis.truth_noise = truth_noise(analysis.blocks, first, second, *input.halves);
        analysis.blocks = extrapolated(std::move(analysis.blocks), first, second);
    }
    if (const auto noise = measured.missing.truth_noise) analysis.truth_noise[kMissingArea] = *noise;
    if (const auto noise = measured.false_occlusion.truth_noise) analysis.truth_noise[kFalseArea] = *noise;
    const std::array<const BlockErrors*, 1> images{&analysis.blocks};
    analysis.intervals = confidence_intervals(images, seed);
    return analysis;
}

}  // namespace aoscore
