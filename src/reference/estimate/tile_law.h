#pragma once

#include "reference/estimate/pixel_spread.h"

#include <span>

namespace aoscore {

/// How the variance of a tile's pixels depends on their visibility V and their samples N: the mean of a block
/// of n of them varies by scale * block_shape().
struct TileLaw {
    double scale = 0;
    double ratio = 0;  ///< by which doubling the rays lowers the variance
    /// From 0 to 1: how surely the occluders are so thin, against the distance of pixels, that strata hardly
    /// help.
    double thinness = 0;
    /// Mean of visibility_shape() over the pixels whose rays do not all agree.
    double mean_shape = 0;
};

/// How a tile's law is taken from its pixels.
struct TileLawRules {
    /// The rays were counted out by earlier estimates: the variance is taken to fall slowly, since tracing
    /// stops where it came out too steep.
    bool chosen = false;
    /// Rays are open or blocked, with nothing between: the scale has a least value that was measured for
    /// these.
    bool binary = true;
};

/// sqrt(V (1 - V) + a / N): how variance depends on visibility, as stratified points at the edge of a
/// shadow have it.
double visibility_shape(const PixelSpread& pixel);

/// n^log2(ratio) for the n rays of one of its blocks, as the usual law has it.
double size_shape(const PixelSpread& pixel);

/// The law of one tile. Most tiles of all scenes that were measured follow one law within a factor of two, so
/// that a tile's own scale is believed as far as its pixels speak for it, and never below a part of the usual
/// one: what has little variance by luck is not told from what has little.
TileLaw law_of_tile(std::span<const PixelSpread> pixels, const TileLawRules& rules);

}  // namespace aoscore
