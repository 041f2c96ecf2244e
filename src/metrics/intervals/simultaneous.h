#pragma once

#include "metrics/intervals/bootstrap.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {

/// A measure with its values over resampled pictures, as resampled() draws them.
struct Resampled {
    double value = 0;
    std::vector<double> draws;
};

/// The indices of two measures whose difference, first less second, is asked for. Their draws are paired.
using MeasurePair = std::pair<std::size_t, std::size_t>;

/// Intervals of the differences of some pairs, which hold all together with 95 % confidence, and so are wider
/// for more pairs. Each is the difference +- c s, where s is the standard deviation of its draws and c the
/// value that the largest |draw - difference| / s of all pairs exceeds in 5 % of the draws, at least 1.96
/// (the studentised maximum; Joseph Romano, Michael Wolf, Exact and Approximate Stepdown Methods for Multiple
/// Hypothesis Testing, 2005, its first step). A difference that no draw changes is exact. Empty where fewer
/// than two draws are numbers. Throws internal_error for draws of unequal number.
std::vector<std::optional<Interval>> simultaneous_intervals(const std::vector<Resampled>& measures,
                                                            const std::vector<MeasurePair>& pairs);

/// The ranks that a measure can have, where 1 is the lowest value: from 1 plus the number of significantly
/// lower ones to the number of those that are not significantly higher.
struct RankRange {
    int best = 1, worst = 1;
    bool operator==(const RankRange&) const = default;
};

/// The significant differences between some measures, and the ranks that follow from them. All ranks together
/// hold the true ones with 95 % confidence (Magne Mogstad, Joseph Romano, Azeem Shaikh, Daniel Wilhelm,
/// Inference for Ranks with Applications to Mobility across Neighbourhoods and Academic Achievement across
/// Countries, 2023). A tie is not transitive, so measures share no places; each has a range of ranks.
class Ranks {
  public:
    explicit Ranks(const std::vector<Resampled>& measures);

    /// The interval of measure a less measure b: 0 to 0 for the same one, empty where it could not be
    /// resampled.
    std::optional<Interval> difference(std::size_t a, std::size_t b) const;
    bool surely_lower(std::size_t a, std::size_t b) const;
    RankRange range(std::size_t measure) const;
    /// The measures that do not differ from it significantly.
    std::vector<std::size_t> ties(std::size_t measure) const;

  private:
    std::size_t count_;
    std::vector<std::optional<Interval>> differences_;  ///< that of a - b is at a * count_ + b
};

}  // namespace aoscore
