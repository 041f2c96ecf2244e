#include "metrics/analysis/analysis.h"

#include "metrics/analysis/beyond_layer.h"
#include "metrics/analysis/tile_pattern.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/intervals/truth_noise.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <array>
#include <utility>

namespace aoscore {

std::optional<ErrorAnalysis> analyse(const MetricInput& input, const PixelFacts& facts, double mask_threshold,
                                     std::uint64_t seed, const std::vector<PixelDivision>* divisions) {
    const std::optional<BestFit> fit = best_fit(input);
    if (!fit) return std::nullopt;
    ErrorAnalysis analysis;
    analysis.fit = *fit;
    const OcclusionMasks masks = occlusion_masks(input, mask_threshold);
    MeasuredMask missing = measure_mask(input, MaskSide::missing, mask_threshold, facts.causes);
    MeasuredMask false_occlusion = measure_mask(input, MaskSide::false_occlusion, mask_threshold);
    analysis.missing = std::move(missing.summary);
    analysis.false_occlusion = std::move(false_occlusion.summary);
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
    analysis.blocks = block_errors(input, mask_threshold);
    if (input.halves != nullptr) {
        const BlockErrors first = block_errors(against_half(input, 0));
        const BlockErrors second = block_errors(against_half(input, 1));
        analysis.truth_noise = truth_noise(analysis.blocks, first, second, *input.halves);
        analysis.blocks = extrapolated(std::move(analysis.blocks), first, second);
    }
    if (missing.truth_noise) analysis.truth_noise[kMissingArea] = *missing.truth_noise;
    if (false_occlusion.truth_noise) analysis.truth_noise[kFalseArea] = *false_occlusion.truth_noise;
    const std::array<const BlockErrors*, 1> images{&analysis.blocks};
    analysis.intervals = confidence_intervals(images, seed);
    return analysis;
}

}  // namespace aoscore
