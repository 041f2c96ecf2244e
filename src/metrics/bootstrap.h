#pragma once

#include "metrics/block_errors.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// Holds a value with 95 % confidence.
struct Interval {
    double low = 0, high = 0;
    bool holds_zero() const { return low <= 0 && high >= 0; }
};

/// What a bootstrap draws from: one image, or one of each of several views.
using BootstrapImages = std::span<const BlockErrors* const>;

/// Values of a metric over 2000 resampled images: blocks are drawn with replacement (Hans Künsch, The
/// Jackknife and the Bootstrap for General Stationary Observations, 1989). Of several images the metric is
/// the mean over them, and images are drawn first, then blocks of each. Draws depend on the seed and on how
/// many blocks the images have, so that two tests of the same truths are resampled alike and their
/// differences, value by value, are paired. NaN where no valid pixel was drawn. `metric` is rmse,
/// rmse_debiased (where the truth's standard error is known), mae, bias or psnr; throws internal_error for
/// another.
std::vector<double> resampled(const std::string& metric, BootstrapImages images, std::uint64_t seed);

/// The middle 95 % of resampled values, or of their differences a - b. Empty where one is infinite or none is
/// a number.
std::optional<Interval> confidence_interval(std::vector<double> values);
std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b);

/// Those of all metrics that can be resampled, by id.
std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed);

}  // namespace aoscore
