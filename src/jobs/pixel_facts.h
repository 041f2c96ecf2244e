#pragma once

#include "metrics/analysis/pixel_facts.h"
#include "reference/truth.h"
#include "scene/camera.h"

namespace aoscore {

/// The facts of a traced truth's pixels: depth, tilt, distance from depth edges, and causes where they were
/// asked for. A depth edge runs between two neighbouring pixels (of four) of which one has no surface, or
/// that lie off both of their tangent planes by more than two pixels' footprints: a crease or a slope is
/// none. Both of its pixels are at distance 0. The causes refer to `truth`, which must outlive them.
PixelFacts pixel_facts(const CameraFrame& frame, const Truth& truth);

}  // namespace aoscore
