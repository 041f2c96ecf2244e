#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore::gltf {

/// A node of the scene that is drawn, with its transform in double precision.
struct PlacedNode {
    int node = 0;  ///< index into the document's nodes
    glm::dmat4 world_from_node{1.0};
};

/// All nodes below the default scene (scene 0 when none is named, the root nodes when there are no scenes),
/// parents before children. Needs no stack per level: a chain of any length is fine. Throws file_error for a
/// node that is reached twice (cycle or second parent), for transforms that are not affine, not finite or a
/// null rotation, and for a scene without nodes.
std::vector<PlacedNode> place_nodes(Document& document);

}  // namespace aoscore::gltf
