#pragma once

#include "reference/truth.h"

namespace aoscore {

/// Standard errors were measured to hold from so many rays a pixel on: the fewest to begin with where an
/// error is asked for and nobody names another count.
inline constexpr int kFewestToTellError = 16;

/// No standard error can be less, as float32 numbers, which truths are, round by as much.
inline constexpr double kLeastError = 6e-8;

/// Standard errors fall by a power of the rays between these two: what a few tiles tell beyond them is
/// chance.
inline constexpr double kFlattestFall = 0.4, kSteepestFall = 1;

/// An error that a few tiles call in reach is stated so many times as large, so that it is in reach of all.
inline constexpr double kReachMargin = 1.1;

/// How many rays pixels get, round by round.
class SamplePlan {
  public:
    /// Where a mean error is asked for, of the pilot that finds the rays for all: see rays_for_mean_error().
    explicit SamplePlan(const TruthSettings& settings);

    /// Rays of the first round.
    int first() const { return first_; }
    /// No pixel gets more.
    int most() const { return most_; }
    /// The count to go to from `samples` rays that left a standard error of `error`; `samples` when that is
    /// enough.
    int next(int samples, double error) const;

  private:
    double max_error_;
    int first_;
    int most_;
};

}  // namespace aoscore
