#pragma once

#include "scene/gltf/document.h"

#include <glm/glm.hpp>

#include <vector>

namespace tinygltf {
class Node;
}

namespace aoscore::gltf {

/// The matrices that take instances of a node's mesh to the node (EXT_mesh_gpu_instancing, Khronos Group); a
/// node without the extension has one identity. Throws file_error at `place` for attributes of different
/// counts, of wrong types, or not finite.
std::vector<glm::dmat4> node_from_instances(Document& document, const tinygltf::Node& node,
                                            const std::string& place);

}  // namespace aoscore::gltf
