#pragma once

#include "reference/integrator/tile.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace aoscore {

/// What a tile's pixels together err at some count of rays a pixel.
struct Rung {
    int samples;
    double error_sum;  ///< of the standard errors of its traced pixels
};

/// How the errors of one tile fell as its rays were doubled.
struct Ladder {
    std::vector<Rung> rungs;   ///< empty: nothing to trace
    std::size_t surfaces = 0;  ///< pixels that count for the mean: traced, and proven open
    std::size_t traced = 0;    ///< pixels that share the rays
};

/// Traces a tile at a price, see SamplePlan.
using Climb = std::function<Ladder(const Tile& tile, double price)>;

/// The price at which the mean standard error over a picture's surfaces comes to `mean_error`, from a random
/// part of its tiles, always the same one: known to a few parts in a hundred for a large picture.
double price_for_mean_error(double mean_error, int width, int height, const Climb& climb);

}  // namespace aoscore
