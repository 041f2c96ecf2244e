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

/// An interval that holds a value with 95 % confidence.
struct Interval {
    double low = 0, high = 0;
    bool holds_zero() const { return low <= 0 && high >= 0; }
};

/// The images that a bootstrap draws from: one, or one of each of several views.
using BootstrapImages = std::span<const BlockErrors* const>;

/// The measures that can be resampled: metrics whose rows have a statistic, and the areas of the masks.
const std::vector<std::string>& bootstrap_measures();

/// Values of a measure over 2000 resampled images: blocks are drawn with replacement (Hans Künsch, The
/// Jackknife and the Bootstrap for General Stationary Observations, 1989). For several images the value is
/// measure_over_views(), and images are drawn first, then blocks of each. Draws depend on the seed and on the
/// number of blocks, so that two tests of the same truths are resampled alike and their differences, value by
/// value, are paired. MS-SSIM, a product over scales, is resampled to first order and from larger squares,
/// where there are at least fifteen; see MapSums. NaN where no valid pixel was drawn, or the images lack the
/// measure's sums. Throws internal_error for a measure that is not among bootstrap_measures().
std::vector<double> resampled(const std::string& measure, BootstrapImages images, std::uint64_t seed);

/// The measure over all blocks of an image, not resampled. NaN without a valid pixel, or where the image
/// lacks the measure's sums. Throws internal_error for a measure that is not among bootstrap_measures().
double value_of_blocks(const std::string& measure, const BlockErrors& image);

/// The middle 95 % of resampled values, or of their differences a - b. Empty where one is infinite or none is
/// a number.
std::optional<Interval> confidence_interval(std::vector<double> values);
std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b);

/// The intervals of all bootstrap_measures() whose sums the images have, by id.
std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed);

}  // namespace aoscore
