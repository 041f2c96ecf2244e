#pragma once

#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/mask_areas.h"

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

/// What can be resampled: the metrics whose rows say how, and the areas of the masks.
const std::vector<std::string>& bootstrap_measures();

/// Values of a measure over 2000 resampled images: blocks are drawn with replacement (Hans Künsch, The
/// Jackknife and the Bootstrap for General Stationary Observations, 1989). Of several images the
/// value is measure_over_views(), and images are drawn first, then blocks of each. Draws depend on the seed
/// and on how many blocks the images have, so that two tests of the same truths are resampled alike and their
/// differences, value by value, are paired. MS-SSIM, a product over scales, is resampled to first order and
/// from larger squares, where there are at least fifteen; see MapSums. NaN where no valid pixel was drawn, or
/// the images lack what the measure is made of. Throws internal_error for another than bootstrap_measures().
std::vector<double> resampled(const std::string& measure, BootstrapImages images, std::uint64_t seed);

/// The middle 95 % of resampled values, or of their differences a - b. Empty where one is infinite or none is
/// a number.
std::optional<Interval> confidence_interval(std::vector<double> values);
std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b);

/// Those of all bootstrap_measures() that the images have the sums of, by id.
std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed);

}  // namespace aoscore
