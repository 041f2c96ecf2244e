#pragma once

#include "reference/estimate/pixel_spread.h"

#include <span>
#include <vector>

namespace aoscore {

/// How the variance of a tile's pixels depends on their visibility V and their samples N: the mean of a block
/// of n of them varies by scale * visibility_shape() * size_shape().
struct TileLaw {
    double scale = 0;
    double ratio = 0;  ///< the usual fall of the variance as rays are doubled, see variance_fall()
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

/// What the usual law says of the n rays of one of its blocks, against one ray.
double size_shape(const PixelSpread& pixel);

/// The law of one tile. Most tiles of all scenes that were measured follow one law within a factor of two, so
/// that a tile's own scale is believed as far as its pixels speak for it, and never below a part of the usual
/// one: what has little variance by luck is not told from what has little.
TileLaw law_of_tile(std::span<const PixelSpread> pixels, const TileLawRules& rules);

/// The scale about each pixel: that of its neighbours in the tile and its own, drawn towards the tile's. What
/// lies in a corner of a tile, such as a railing before a wall, is told from the rest by it.
std::vector<double> scales_about(std::span<const PixelSpread> pixels, const TileLaw& law,
                                 const TileLawRules& rules);

}  // namespace aoscore
