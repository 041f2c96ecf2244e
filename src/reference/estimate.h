#pragma once

#include <span>
#include <vector>

namespace aoscore {

/// A pixel's visibility and its standard error.
struct Estimate {
    double visibility = 1;
    double standard_error = 0;
};

/// What the point sets of one pixel say by themselves.
struct PixelSpread {
    double visibility = 1;
    double variance = 0;  ///< of the pooled mean, from the spread of the sets' means
    int freedom = 0;      ///< degrees of freedom of that: sets - 1
    int samples = 0;
};

/// The pooled mean of `samples` rays from point sets whose darkenings add up to `darkening_sums` (one a set;
/// sample k belongs to set k mod the number of sets). Sets may differ by one sample: each set's mean is taken
/// to have a variance inverse to its size.
PixelSpread pixel_spread(std::span<const double> darkening_sums, int samples);

/// Standard errors of the pixels of one tile. A pixel's own spread has few degrees of freedom, so it is
/// moderated by what its neighbours show, as Smyth (Linear Models and Empirical Bayes Methods for Assessing
/// Differential Expression, 2004) does for genes: each variance is drawn towards the one that neighbours of
/// like visibility have, after scaling by sqrt(V (1 - V) + 1/(2 N)) N^-3/2, the law of stratified points at
/// the edge of a shadow. See Truth for the floor.
std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels);

}  // namespace aoscore
