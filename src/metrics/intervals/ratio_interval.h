#pragma once

#include "metrics/intervals/bootstrap.h"

#include <optional>
#include <vector>

namespace aoscore {

/// The 95 % interval of a ratio of sums over the blocks of a picture, such as a mean over a mask, whose size
/// differs from block to block: 1.96 times the root of the variance that the blocks' distances from the ratio
/// have, to first order (William Cochran, Sampling Techniques, 1977, chapter 6). The noise of the truth is
/// part of these distances. Empty where fewer than kFewestBlocks blocks have a part in the divisor, or where
/// that is not positive. `dividends` and `divisors` have one size.
std::optional<Interval> ratio_interval(const std::vector<double>& dividends,
                                       const std::vector<double>& divisors);

}  // namespace aoscore
