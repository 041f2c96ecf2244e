#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

#include <vector>

namespace aoscore::gltf {

/// The views of the scene's camera nodes, in world coordinates, named after their nodes. A node's scale does
/// not touch its view; a mirrored node gives the view of its axes (a camera cannot mirror: a warning says
/// so), a node scaled to nothing none. `scene` tells how far the view must reach: glTF's far plane may be
/// absent or absurd, and a depth buffer keeps its precision only when near and far are no further apart than
/// the picture needs. `bounds` are in world coordinates.
std::vector<View> read_cameras(Document& document, const std::vector<PlacedNode>& nodes,
                               const Bounds& bounds);

}  // namespace aoscore::gltf
