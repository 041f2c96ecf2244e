#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace aoscore::gltf {

/// The triangles of a primitive's index list, with one winding: `mode` is glTF's 4 (list), 5 (strip) or 6
/// (fan). Indices at the end that do not fill a triangle are ignored.
std::vector<glm::uvec3> triangles_of(const std::vector<std::uint32_t>& indices, int mode);

}  // namespace aoscore::gltf
