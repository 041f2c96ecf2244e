#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/nodes.h"

#include <glm/glm.hpp>

#include <map>
#include <set>
#include <vector>

namespace tinygltf {
class Node;
}

namespace aoscore::gltf {

/// The shape that a node of the rest pose gives its mesh: nodes of equal pose show the same triangles.
struct Pose {
    std::vector<double> weights;  ///< weights of the morph targets; empty when all are 0
    int skin = -1;                ///< -1: the node itself places the mesh

    bool operator<(const Pose& other) const {
        return skin != other.skin ? skin < other.skin : weights < other.weights;
    }
};

/// The node's weights, else its mesh's, else none, and the node's skin. Where a node has a skin and its mesh
/// no joints, the skin is ignored, with a warning.
Pose pose_of(Document& document, const tinygltf::Node& node);

/// The matrices of a skin's joints in the rest pose, which take a vertex, as modelled, to its world position
/// less `anchor`.
struct JointMatrices {
    std::vector<glm::dmat4> anchored_from_mesh;
    glm::dvec3 anchor{
        0};  ///< the first joint's place, so that float32 keeps details far from the world's origin
};

/// The joint matrices of skins, made as they are asked for. A skinned mesh stands where its joints are: the
/// transform of the node that shows it does not count (glTF 2.0, Khronos 2021, section 3.7.3.3).
class Skins {
  public:
    Skins(Document& document, const std::vector<PlacedNode>& nodes);
    /// Throws file_error for inverse bind matrices that are too few or no matrices.
    const JointMatrices& joints(int skin);
    /// Whether some joint of the skin moves.
    bool is_dynamic(int skin) const;

  private:
    JointMatrices read(int skin);
    const glm::dmat4& world_from_joint(int node);

    Document& document_;
    std::map<int, glm::dmat4> world_from_node_;
    std::set<int> dynamic_nodes_;
    std::map<int, JointMatrices> read_;
};

}  // namespace aoscore::gltf
