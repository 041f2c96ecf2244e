#pragma once

#include "reference/sampling/pilot.h"
#include "reference/truth.h"

namespace aoscore {

/// Standard errors were measured to hold from so many rays a pixel on: the fewest to begin with where an
/// error is asked for and nobody names another count.
inline constexpr int kFewestToTellError = 16;

/// How many rays pixels get, round by round.
class SamplePlan {
  public:
    /// `spread`: where a mean error is asked for, tiles begin with its first rays, or with as many as the
    /// settings name where that is 0, and go on while one more ray for each of their pixels would lower their
    /// mean standard error by more than about its least gain. Rays are the fewest where every tile pays the
    /// same.
    explicit SamplePlan(const TruthSettings& settings, const RaySpread& spread = {});

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

  private:
    double max_error_;
    double least_gain_;
    bool by_tile_;
    int first_;
    int most_;
};

}  // namespace aoscore
