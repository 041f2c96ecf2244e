#include "scene/gltf/primitive_topology.h"

namespace aoscore::gltf {

std::vector<glm::uvec3> triangles_of(const std::vector<std::uint32_t>& indices, int mode) {
    constexpr int kStrip = 5, kFan = 6;
    std::vector<glm::uvec3> triangles;
    if (mode == kStrip || mode == kFan) {
        for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
            const std::size_t odd = mode == kStrip ? i % 2 : 0;
            triangles.push_back(mode == kFan
                                    ? glm::uvec3(indices[i + 1], indices[i + 2], indices[0])
                                    : glm::uvec3(indices[i], indices[i + 1 + odd], indices[i + 2 - odd]));
        }
    } else {
        triangles.reserve(indices.size() / 3);
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
        }
    }
    return triangles;
}

}  // namespace aoscore::gltf
