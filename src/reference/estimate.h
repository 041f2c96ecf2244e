#pragma once

#include <span>

namespace aoscore {

/// A pixel's visibility and its standard error.
struct Estimate {
    double visibility = 1;
    double standard_error = 0;
};

/// The pooled mean of `samples` rays from point sets whose darkenings add up to `darkening_sums` (one a set;
/// sample k belongs to set k mod the number of sets). Sets may differ by one sample: each set's mean is taken
/// to have a variance inverse to its size. See Truth for what the standard error means and where its floor
/// lies.
Estimate pooled_estimate(std::span<const double> darkening_sums, int samples);

}  // namespace aoscore
