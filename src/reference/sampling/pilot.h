#pragma once

#include "reference/integrator/tile.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// The error of a tile's pixels together at some count of rays a pixel.
struct ErrorStep {
    int samples;
    double error_sum;  ///< of the standard errors of its traced pixels
};

/// How the errors of one tile fell with its rays.
struct TileConvergence {
    std::vector<ErrorStep> steps;  ///< empty: nothing to trace
    std::size_t surfaces = 0;      ///< pixels that count for the mean: traced, and proven open
    std::size_t traced = 0;        ///< pixels that share the rays
};

/// How tiles get their rays, see SamplePlan: all of them `first` a pixel at once, then those whose gain is
/// larger than the least. `first` of 0: as the settings say.
struct RaySpread {
    int first = 0;
    double least_gain = 0;
};

/// Gives the pixels of a tile of the pilot, by its number, so many rays each, and adds a step.
using TraceTileTo = std::function<TileConvergence(std::size_t number, int samples)>;

/// The tiles of a picture that tell how its rays are spread, at the points of a Sobol sequence; all of a
/// small picture.
std::vector<Tile> pilot_tiles(int width, int height);

/// Finds how to reach a mean standard error of `mean_error` over the surfaces of so many tiles, beginning
/// with `first` rays a pixel or more and ending with `most`, powers of two: known to a few parts in a hundred
/// for a large picture. Of all that come to this error, the spread that is traced the soonest: few rays at
/// first spare rays where a tile needs no more, but rays are traced the faster the more there are of them at
/// once.
RaySpread spread_for_mean_error(double mean_error, std::size_t tiles, int first, int most,
                                const TraceTileTo& trace_to);

}  // namespace aoscore
