#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace aoscore {

/// Pairs of blocks, pairs of such pairs, and so on: log2(kBlocks) levels.
inline constexpr std::size_t kLevels = 3;

/// No tile has more pixels than this to a side.
inline constexpr int kLargestTile = 8;

/// Where a pixel lies in its tile, from 0 to kLargestTile - 1.
struct PlaceInTile {
    int column = 0, row = 0;
};

/// The spread of the blocks of one pixel's samples. Level l compares means of 2^l blocks with their
/// siblings, the next 2^l blocks, as nested scrambling pairs them.
struct PixelSpread {
    double visibility = 1;
    int samples = 0;
    PlaceInTile place;
    std::array<int, kLevels> pairs{};  ///< of each level: its degrees of freedom
    /// Mean of ((a - b) / 2)^2 over the pairs of each level, an unbiased estimate of V(n) - V(2n), where V(n)
    /// is the variance of the mean of an aligned run of n samples; 0 without pairs.
    std::array<double, kLevels> differences{};
    int freedom() const { return pairs[0] + pairs[1] + pairs[2]; }
    /// All rays open, or all blocked.
    bool agrees() const { return visibility == 0 || visibility == 1; }
};

/// The mean of `samples` rays whose occlusions add up, block by block of block_size(samples), to
/// `occlusion_sums`.
PixelSpread pixel_spread(std::span<const double> occlusion_sums, int samples, PlaceInTile place = {});

/// The variance of the mean of one block as the pixel's own differences have it, where variances fall by
/// variance_fall(ratio); 0 without pairs.
double block_variance(const PixelSpread& pixel, double ratio);

/// The variance of the mean of `samples` points of a nested scrambled sequence, in units of that of one of
/// their blocks, where variances fall by variance_fall(ratio).
///
/// Under nested scrambling the covariance of two blocks depends only on the smallest aligned run that holds
/// both, and V(2n) = (V(n) + covariance of siblings) / 2 gives it from V at each level (the nested analysis
/// of variance of Owen, Monte Carlo Variance of Scrambled Net Quadrature, 1997).
double pooled_variance(int samples, double ratio);

}  // namespace aoscore
