#pragma once

#include "metrics/analysis/repeats.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace aoscore {

/// The sum of `some` over that of `all`; empty where it is not finite.
inline std::optional<double> ratio_of_sums(const std::vector<double>& some, const std::vector<double>& all) {
    const double ratio =
        std::accumulate(some.begin(), some.end(), 0.0) / std::accumulate(all.begin(), all.end(), 0.0);
    return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

/// The part of the hidden occlusion that is found at the fitted strength; empty where it is not known.
inline std::optional<double> found_share(const std::optional<FoundOcclusion>& found) {
    return found ? ratio_of_sums(found->found_fitted, found->hidden) : std::nullopt;
}

/// The standard deviation of a pixel over seeds, as a root of the mean square over the pixels.
inline std::optional<double> noise_over_seeds(const Repeats& repeats) {
    const std::optional<double> variance = ratio_of_sums(repeats.variance, repeats.counts);
    return variance ? std::optional(std::sqrt(*variance)) : std::nullopt;
}

/// The same with the sums over all blocks instead of each block's: all values stay, and no interval can be
/// made.
inline Repeats over_all_blocks(Repeats repeats) {
    const auto add_up = [](std::vector<double>& sums) {
        if (!sums.empty()) sums = {std::accumulate(sums.begin(), sums.end(), 0.0)};
    };
    for (auto* const sums : {&repeats.counts, &repeats.variance, &repeats.raw_variance}) add_up(*sums);
    for (auto* const found : {&repeats.of_truth, &repeats.of_layers, &repeats.of_grazing}) {
        if (!*found) continue;
        for (auto* const sums : {&(*found)->hidden, &(*found)->found, &(*found)->found_fitted,
                                 &(*found)->visible, &(*found)->kept, &(*found)->pixels, &(*found)->finders,
                                 &(*found)->parts, &(*found)->squared_parts})
            add_up(*sums);
    }
    for (auto* const distance : {&repeats.raw_from_converged, &repeats.from_converged}) {
        if (!*distance) continue;
        for (auto* const sums : {&(*distance)->counts, &(*distance)->squares, &(*distance)->bands})
            add_up(*sums);
    }
    for (auto* const angles : {&repeats.hidden_angles, &repeats.other_angles}) {
        for (auto& [signal, blocks] : *angles) {
            for (auto* const sums : {&blocks.counts, &blocks.absolute_sums, &blocks.signed_sums})
                add_up(*sums);
        }
    }
    return repeats;
}

}  // namespace aoscore
