#include "metrics/analysis/analysis.h"

#include "metrics/analysis/beyond_layer.h"
#include "metrics/analysis/measured_masks.h"
#include "metrics/analysis/tile_pattern.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/intervals/ratio_interval.h"
#include "metrics/intervals/truth_noise.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {
namespace {

/// Adds how sure the numbers of a mask are.
void add_certainty(ErrorAnalysis& analysis, const MaskArea& area, const MeasuredMask& mask,
                   const MaskTotal& total) {
    const std::string id(area.id), mean_id(area.mean_id);
    if (mask.truth_noise) analysis.truth_noise[id] = *mask.truth_noise;
    if (mask.mean_noise) analysis.truth_noise[mean_id] = *mask.mean_noise;
    if (const auto interval = ratio_interval(total.error_blocks, total.share_blocks))
        analysis.intervals[mean_id] = *interval;
}

}  // namespace
std::optional<ErrorAnalysis> analyse(const MetricInput& input, const PixelFacts& facts, double mask_threshold,
                                     std::uint64_t seed, const std::vector<PixelDivision>* divisions) {
    const std::optional<BestFit> fit = best_fit(input);
    if (!fit) return std::nullopt;
    ErrorAnalysis analysis;
    analysis.fit = *fit;
    const OcclusionMasks masks = occlusion_masks(input, mask_threshold);
    const MaskTotals totals = mask_totals(input, mask_threshold, facts.causes);
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
    analysis.blocks = with_masks(block_errors(input), totals);
    if (input.halves != nullptr) {
        const BlockErrors first = block_errors(against_half(input, 0));
        const BlockErrors second = block_errors(against_half(input, 1));
        analysis.truth_noise = truth_noise(analysis.blocks, first, second, *input.halves);
        analysis.blocks = extrapolated(std::move(analysis.blocks), first, second);
    }
    const std::array<const BlockErrors*, 1> images{&analysis.blocks};
    analysis.intervals = confidence_intervals(images, seed);
    const auto& [missing, false_occlusion] = mask_areas();
    add_certainty(analysis, missing, measured.missing, totals.missing);
    add_certainty(analysis, false_occlusion, measured.false_occlusion, totals.false_occlusion);
    return analysis;
}

}  // namespace aoscore
