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

/// How the errors of one tile fell as its rays were doubled.
struct TileConvergence {
    std::vector<ErrorStep> steps;  ///< empty: nothing to trace
    std::size_t surfaces = 0;      ///< pixels that count for the mean: traced, and proven open
    std::size_t traced = 0;        ///< pixels that share the rays
};

/// Traces a tile until its gain is `least_gain`, see SamplePlan.
using TraceTileTo = std::function<TileConvergence(const Tile& tile, double least_gain)>;

/// The least gain at which the mean standard error over a picture's surfaces comes to `mean_error`, from a
/// random part of its tiles, always the same one: known to a few parts in a hundred for a large picture.
double gain_for_mean_error(double mean_error, int width, int height, const TraceTileTo& trace_to);

}  // namespace aoscore
