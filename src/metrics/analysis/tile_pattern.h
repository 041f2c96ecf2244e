#pragma once

#include "metrics/metric.h"

#include <optional>

namespace aoscore {

/// The side of the tile that patterns are looked for at, px: that of the tiled rotations in use.
inline constexpr int kTile_px = 4;

/// What of an error comes again every kTile_px pixels, across and down, as the traces of a tiled rotation do:
/// the root of half the dip that the mean squared difference of two pixels' errors has at that distance,
/// against the cubic through those one and two pixels nearer and farther (after the variogram of Matheron,
/// Principles of Geostatistics, 1963). In visibility; 0 for noise and for edges. Empty where no two valid
/// pixels are far enough apart. Throws sizes_differ.
std::optional<double> tile_pattern(const MetricInput& input);

}  // namespace aoscore
