#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace aoscore {

/// A pixel's visibility and its standard error.
struct Estimate {
    double visibility = 1;
    double standard_error = 0;
};

/// Pairs of blocks, pairs of such pairs, and so on: log2(kBlocks) levels.
inline constexpr std::size_t kLevels = 3;

/// What the blocks of one pixel's samples say by themselves. Level l compares means of 2^l blocks with their
/// siblings, the next 2^l blocks, as nested scrambling pairs them.
struct PixelSpread {
    double visibility = 1;
    int samples = 0;
    std::array<int, kLevels> pairs{};  ///< of each level: its degrees of freedom
    /// Mean of ((a - b) / 2)^2 over the pairs of each level, an unbiased estimate of V(n) - V(2n), where V(n)
    /// is the variance of the mean of an aligned run of n samples; 0 without pairs.
    std::array<double, kLevels> differences{};
    int freedom() const { return pairs[0] + pairs[1] + pairs[2]; }
};

/// The mean of `samples` rays whose darkenings add up, block by block of block_size(samples), to
/// `darkening_sums`.
PixelSpread pixel_spread(std::span<const double> darkening_sums, int samples);

/// The variance of the mean of `samples` points of a nested scrambled sequence, in units of that of one of
/// their blocks, where the mean of twice as many points, aligned, has `ratio` of the variance.
///
/// Under nested scrambling the covariance of two blocks depends only on the smallest aligned run that holds
/// both, and V(2n) = (V(n) + covariance of siblings) / 2 gives it from V at each level (the nested analysis
/// of variance of Owen, Monte Carlo Variance of Scrambled Net Quadrature, 1997).
double pooled_variance(int samples, double ratio);

/// The standard error of a pixel whose `samples` (>= 1) rays all agree, where of the `alike` pixels of its
/// tile that see mostly the same `agreeing` (1 to `alike`) agree as well. It leaves out x / samples, where x
/// is the number of rays that should have disagreed: stratified points meet with none of x < 1 of them in a
/// share 1 - x of the pixels, independent ones, or points before thin occluders across many strata, in a
/// share exp(-x). Between both laws, nearer to the first, lies what tests show within 25 %. A quarter of one
/// more disagreeing ray among all who agree keeps the error above 0: a pixel that is alone states half of
/// what one ray would make; where a whole tile agrees, the true error was seen to be a third of the stated
/// one or less.
double error_of_agreement(int samples, int agreeing, int alike);

/// Standard errors of the pixels of one tile. A pixel's own blocks have few degrees of freedom, so that its
/// variance is drawn towards the one that neighbours of like visibility have, as Smyth (Linear Models and
/// Empirical Bayes Methods for Assessing Differential Expression, 2004) does for genes, after scaling by
/// sqrt(V (1 - V) + 1/(4 N)) N^-3/2, the law of stratified points at the edge of a shadow. How far variance
/// falls from level to level is estimated likewise, unless `chosen`: where sample counts were chosen by
/// earlier estimates, it is taken to fall slowly, since tracing stops where it came out too steep.
/// Nothing states less than a lone pixel does by error_of_agreement(), unless its whole tile backs it.
std::vector<Estimate> moderated_estimates(std::span<const PixelSpread> pixels, bool chosen);

}  // namespace aoscore
