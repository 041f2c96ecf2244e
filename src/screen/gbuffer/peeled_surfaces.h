#pragma once

#include "scene/camera.h"
#include "screen/gbuffer/scene_geometry.h"
#include "screen/gbuffer/surface_layer.h"

#include <vector>

namespace aoscore {

/// Peels off all surfaces of the scene, one pass a layer (Everitt, Interactive Order-Independent
/// Transparency, 2001), until none is left or SurfaceChannels::kMost are. Row 0 at the top.
std::vector<SurfaceLayer> peel_surfaces(const SceneGeometry& geometry, const CameraFrame& frame);

}  // namespace aoscore
