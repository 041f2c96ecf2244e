#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <vector>

namespace aoscore::gltf {

/// A node of the scene, with its transform in double precision.
struct PlacedNode {
    int node = 0;  ///< index into the document's nodes
    glm::dmat4 world_from_node{1.0};
    bool is_visible = true;  ///< false where KHR_node_visibility of it or a parent hides its mesh
    /// It moves: an animation targets it or a parent. Where "extras" of one of them has a boolean "dynamic",
    /// that of the nearest counts.
    bool is_dynamic = false;
};

/// All nodes below the default scene (scene 0 when none is named, the root nodes when there are no scenes),
/// parents before children. It is not recursive, so that nodes may be nested to any depth. Throws file_error
/// for a node that is reached twice (cycle or second parent), for transforms that are not affine or not
/// finite, and for a scene without nodes.
std::vector<PlacedNode> place_nodes(Document& document);

/// The transform of a node outside of that scene, by its parents. Throws file_error for a cycle.
glm::dmat4 world_from_detached(Document& document, int node);

/// Translation, rotation (a quaternion x, y, z, w) and scale as one matrix. A rotation of another length is
/// normalised, and one of length 0 ignored, with a warning where that is more than rounding.
glm::dmat4 matrix_of_parts(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale,
                           Document& document);

}  // namespace aoscore::gltf
