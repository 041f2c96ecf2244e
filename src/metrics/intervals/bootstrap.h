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

bool can_be_resampled(const std::string& measure);
/// What stands for the interval of such a measure where there is none.
inline constexpr char kNoInterval[] = "no interval";

/// Values of a measure over 2000 resampled images: blocks are drawn with replacement (Hans Künsch, The
/// Jackknife and the Bootstrap for General Stationary Observations, 1989). For several images the value is
/// measure_over_views(), and images are drawn first, then blocks of each. Draws depend on the seed and on the
/// number of blocks, so that two tests of the same truths are resampled alike and their differences, value by
/// value, are paired. MS-SSIM, a product over scales, is resampled to first order and from larger squares,
/// where there are at least fifteen; see MapSums. NaN where no valid pixel was drawn, where the images lack
/// the measure's sums, and where one of them has too few blocks, see why_no_intervals(). Throws
/// internal_error for a measure that is not among bootstrap_measures().
std::vector<double> resampled(const std::string& measure, BootstrapImages images, std::uint64_t seed);

/// Says in words why an image is too small for any interval: its valid pixels lie in fewer than kFewestBlocks
/// blocks. Empty where they do not.
std::string why_no_intervals(const BlockErrors& image);

/// The measure over all blocks of an image, not resampled. NaN without a valid pixel, or where the image
/// lacks the measure's sums. Throws internal_error for a measure that is not among bootstrap_measures().
double value_of_blocks(const std::string& measure, const BlockErrors& image);

/// The middle 95 % of resampled values, or of their differences a - b. Empty where one is infinite, where
/// none is a number, and where all of the middle are the same: that tells nothing of how far the value may
/// move.
std::optional<Interval> confidence_interval(std::vector<double> values);
std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b);

/// The intervals of all bootstrap_measures() whose sums the images have, by id.
std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed);

}  // namespace aoscore
