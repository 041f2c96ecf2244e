#pragma once

#include "reference/truth.h"

namespace aoscore {

/// Standard errors were measured to hold from so many rays a pixel on: the fewest to begin with where an
/// error is asked for and nobody names another count.
inline constexpr int kFewestToTellError = 16;

/// How many rays pixels get, round by round.
class SamplePlan {
  public:
    /// `least_gain`: where a mean error is asked for, tiles go on while one more ray for each of their pixels
    /// would lower their mean standard error by more than about this. Lowest where every tile pays the same.
    explicit SamplePlan(const TruthSettings& settings, double least_gain = 0);

    /// Rays of the first round.
    int first() const { return first_; }
    /// No pixel gets more.
    int most() const { return most_; }
    /// The count to go to from `samples` rays that left a standard error of `error`; `samples` when that is
    /// enough.
    int next(int samples, double error) const;
    /// Whether all pixels of a tile get the same.
    bool by_tile() const { return by_tile_; }
    /// The count for all pixels of a tile to go to from `samples` rays that left a mean standard error of
    /// `mean_error`: twice as many, or at once as many as doubling by doubling would surely come to, since
    /// rays are traced faster the more there are of them; `samples` when that is enough.
    int next_of_tile(int samples, double mean_error) const;
    /// The same, never more than twice as many.
    int double_for_tile(int samples, double mean_error) const;

  private:
    double max_error_;
    double least_gain_;
    bool by_tile_;
    int first_;
    int most_;
};

}  // namespace aoscore
