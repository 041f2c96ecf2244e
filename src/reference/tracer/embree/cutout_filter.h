#pragma once

#include "reference/tracer/embree/embree_scene.h"

namespace aoscore {

/// Makes rays pass through the holes of a cut-out geometry, whose user data is its TraceGeometry.
void set_cutout_filter(RTCGeometry geometry);

}  // namespace aoscore
