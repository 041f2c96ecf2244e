#include "scene/mesh_repair.h"

#include <cmath>

namespace aoscore {
namespace {

/// The unit vector; zero when there is no direction.
glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0);
}

}  // namespace

std::size_t drop_degenerate_triangles(Mesh& mesh) {
    return std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
        return triangle_normal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]) ==
               glm::dvec3(0.0);
    });
}

std::size_t repair_normals(Mesh& mesh) {
    std::size_t bad = 0;
    for (glm::vec3& normal : mesh.normals) {
        normal = unit_or_zero(normal);
        if (normal == glm::vec3(0)) ++bad;
    }
    if (bad == 0) return 0;
    if (bad == mesh.normals.size()) {
        mesh.normals.clear();
        return bad;
    }
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::dvec3 twice_area = glm::cross(b - a, c - a);
        for (int corner = 0; corner < 3; ++corner) sums[t[corner]] += twice_area;
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (mesh.normals[i] != glm::vec3(0)) continue;
        mesh.normals[i] = unit_or_zero(sums[i]);
        // Its faces cancel out, or have no area: any direction will do.
        if (mesh.normals[i] == glm::vec3(0)) mesh.normals[i] = glm::vec3(0, 1, 0);
    }
    return bad;
}

}  // namespace aoscore
