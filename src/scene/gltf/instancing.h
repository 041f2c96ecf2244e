#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <vector>

namespace tinygltf {
class Node;
}

namespace aoscore::gltf {

/// What takes each instance of a node's mesh to the node (EXT_mesh_gpu_instancing, Khronos Group); one
/// identity for a node that has no instances of its own. Throws file_error at `place` for attributes of
/// different counts, of other types, and that are not finite.
std::vector<glm::dmat4> node_from_instances(Document& document, const tinygltf::Node& node,
                                            const std::string& place);

}  // namespace aoscore::gltf
