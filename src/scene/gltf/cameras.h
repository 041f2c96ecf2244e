#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

#include <vector>

namespace aoscore::gltf {

/// The views of the scene's camera nodes, in world coordinates, named after their nodes. A node's scale does
/// not change its view; a mirrored node gives the view of its axes, with a warning, since a camera cannot
/// mirror; a node of zero scale gives none. `bounds`, in world coordinates, limit the depth range: glTF's far
/// plane may be absent or absurd, and a depth buffer keeps its precision only when near and far are no
/// further apart than the picture needs.
std::vector<View> read_cameras(Document& document, const std::vector<PlacedNode>& nodes,
                               const Bounds& bounds);

}  // namespace aoscore::gltf
