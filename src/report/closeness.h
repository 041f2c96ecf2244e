#pragma once

#include "core/image.h"
#include "results/results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Squared error summed over square blocks of an image: what is resampled to learn how sure a difference is.
struct BlockErrors {
    std::vector<double> squared_sums;
    std::vector<double> counts;  ///< valid pixels of each block
};
/// Blocks of 1/24 of the width. All three have one size.
BlockErrors block_errors(const ImageF& truth, const ImageF& test, const Mask& valid);

/// The interval that holds the difference of two mean squared errors, a - b, with 95 % confidence: paired
/// bootstrap over blocks (Künsch, The jackknife and the bootstrap for general stationary observations, 1989).
/// The truth's noise is common to both and cancels.
struct Interval {
    double low = 0, high = 0;
    bool holds_zero() const { return low <= 0 && high >= 0; }
};
Interval mse_difference(const BlockErrors& a, const BlockErrors& b, std::uint64_t seed);

/// The id of the metric that ranks these cells: rmse_debiased where every one that did not fail has it, else
/// rmse.
std::string ranking_metric(const std::vector<const CellRecord*>& cells);

/// Its value in a cell; empty where it failed or has none.
std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric);

}  // namespace aoscore
