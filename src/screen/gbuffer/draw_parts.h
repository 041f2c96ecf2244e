#pragma once

#include "scene/camera.h"
#include "screen/gbuffer/scene_geometry.h"

#include <span>
#include <vector>

namespace aoscore {

/// All of a scene, about from the nearest to the farthest: by the middles of meshes.
std::vector<SceneGeometry::Draw> from_the_nearest(const SceneGeometry& geometry, const CameraFrame& camera);

/// The draws, in order, in parts of these shares of their triangles, which add up to 1. A mesh may lie in
/// several parts. In each part cut-outs come last, since they need another program.
std::vector<std::vector<SceneGeometry::Draw>> parts_of(const SceneGeometry& geometry,
                                                       std::span<const SceneGeometry::Draw> draws,
                                                       std::span<const double> shares);

}  // namespace aoscore
