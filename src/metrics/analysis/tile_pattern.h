#pragma once

#include "metrics/metric.h"

#include <optional>

namespace aoscore {

/// The side in px of the tile of rotations that methods use, whose pattern is looked for.
inline constexpr int kTile_px = 4;

/// The part of an error that repeats every kTile_px pixels, across and down, as traces of a tiled rotation
/// do: the root of half the dip of the mean squared difference of two pixels' errors at that distance,
/// against the cubic through the distances one and two pixels nearer and farther (after the variogram of
/// Matheron, Principles of Geostatistics, 1963). It is in visibility, and 0 for noise and for edges. Empty
/// where no two valid pixels are far enough apart. Throws sizes_differ.
std::optional<double> tile_pattern(const MetricInput& input);

}  // namespace aoscore
