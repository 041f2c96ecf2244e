#pragma once

#include "metrics/intervals/bootstrap.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {

/// A measure and its values over resampled pictures, as resampled() draws them.
struct Resampled {
    double value = 0;
    std::vector<double> draws;
};

/// Indices of two measures whose difference, first less second, is asked for. Both were drawn alike.
using MeasurePair = std::pair<std::size_t, std::size_t>;

/// Intervals of the differences of some pairs that hold all together with 95 % confidence, so that the more
/// is compared, the wider each is: the difference +- c s, where s is the standard deviation of its draws and
/// c the value that the largest |draw - difference| / s of all pairs exceeds in 5 % of the draws, at least
/// 1.96 (the studentised maximum; Joseph Romano, Michael Wolf, Exact and Approximate Stepdown Methods for
/// Multiple Hypothesis Testing, 2005, its first step). A difference that no draw changes is exact. Empty
/// where fewer than two draws are numbers. Throws internal_error for draws of unequal number.
std::vector<std::optional<Interval>> simultaneous_intervals(const std::vector<Resampled>& measures,
                                                            const std::vector<MeasurePair>& pairs);

/// The ranks that a measure can have, 1 the lowest value: 1 and how many others are surely lower, to all but
/// those that are surely higher.
struct RankRange {
    int best = 1, worst = 1;
    bool operator==(const RankRange&) const = default;
};

/// Which of some measures are surely lower than which others, and the ranks that follow. All of them together
/// hold the true ranks with 95 % confidence (Magne Mogstad, Joseph Romano, Azeem Shaikh, Daniel Wilhelm,
/// Inference for Ranks with Applications to Mobility across Neighbourhoods and Academic Achievement across
/// Countries, 2023). Not being told apart is not transitive, and no place is shared: each measure has its
/// range.
class Ranks {
  public:
    explicit Ranks(const std::vector<Resampled>& measures);

    /// Of measure a less measure b; of 0 to 0 for the same one, empty where it could not be resampled.
    std::optional<Interval> difference(std::size_t a, std::size_t b) const;
    bool surely_lower(std::size_t a, std::size_t b) const;
    RankRange range(std::size_t measure) const;
    /// The others that it cannot be told apart from.
    std::vector<std::size_t> ties(std::size_t measure) const;

  private:
    std::size_t count_;
    std::vector<std::optional<Interval>> differences_;  ///< of a - b at a * count_ + b
};

}  // namespace aoscore
