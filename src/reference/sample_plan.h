#pragma once

#include "reference/truth.h"

namespace aoscore {

/// How many rays pixels get, round by round.
class SamplePlan {
  public:
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
