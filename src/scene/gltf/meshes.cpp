#include "scene/gltf/meshes.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "scene/gltf/primitive_data.h"
#include "scene/gltf/primitive_topology.h"
#include "scene/gltf/vertex_reader.h"
#include "scene/mesh_repair.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aoscore::gltf {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

/// Moves the mesh to its own centre on the axes where it lies far off for its size. That loses nothing: such
/// coordinates are so close to each other that float32 holds their differences.
glm::dvec3 recentre(Mesh& mesh) {
    constexpr double kFarOff = 64;
    glm::vec3 low = mesh.positions[0], high = mesh.positions[0];
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 extent = glm::dvec3(high) - glm::dvec3(low);
    const double largest = std::max({extent.x, extent.y, extent.z});
    glm::dvec3 centre(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = 0.5 * (static_cast<double>(low[axis]) + static_cast<double>(high[axis]));
        if (std::abs(middle) > kFarOff * largest) centre[axis] = middle;
    }
    if (centre != glm::dvec3(0.0)) {
        for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) - centre);
    }
    return centre;
}

}  // namespace

std::vector<DecodedMesh> MeshReader::read(int mesh, const Pose& pose) {
    std::vector<DecodedMesh> decoded;
    const std::size_t count = document_.model->meshes[static_cast<std::size_t>(mesh)].primitives.size();
    for (std::size_t i = 0; i < count; ++i) {
        throw_if_interrupted();
        if (auto primitive = read_primitive(mesh, i, pose)) decoded.push_back(std::move(*primitive));
    }
    return decoded;
}

void MeshReader::compact(Mesh& mesh, VertexReader& vertices) {
    for (glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& index = new_index_[triangle[corner]];
            if (index == kUnused) {
                index = static_cast<std::uint32_t>(mesh.positions.size());
                vertices.append(mesh, triangle[corner]);
            }
            triangle[corner] = index;
        }
    }
}

std::optional<DecodedMesh> MeshReader::read_primitive(int mesh_index, std::size_t primitive_index,
                                                      const Pose& pose) {
    const auto& primitive =
        document_.model->meshes[static_cast<std::size_t>(mesh_index)].primitives[primitive_index];
    if (primitive.mode != -1 && primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        document_.warn("primitives of points and lines are left out: they have no surface");
        return std::nullopt;
    }
    PrimitiveData data(
        document_, primitive,
        fmt::format("{}: meshes[{}].primitives[{}]", document_.where, mesh_index, primitive_index));
    DecodedMesh decoded;
    Mesh& mesh = decoded.mesh;
    mesh.material = materials_.index_of(primitive.material);
    const auto material = static_cast<std::size_t>(mesh.material);
    const JointMatrices* joints = pose.skin >= 0 ? &skins_.joints(pose.skin) : nullptr;
    VertexReader vertices(document_, primitive, data, materials_.texcoords[material],
                          materials_.materials[material].is_cutout(), pose.weights, joints);
    if (!vertices.has_positions()) return std::nullopt;

    std::vector<std::uint32_t> corners = data.corners(vertices.count());
    if (corners.size() < 3 || (data.mode() == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)) {
        document_.warn("primitives have left-over indices that make no triangle");
    }
    mesh.triangles = triangles_of(corners, data.mode());
    // Many primitives may share one long accessor: keep the vertices that this one uses, in the order of use.
    if (new_index_.size() < vertices.count()) {
        document_.budget.take((vertices.count() - new_index_.size()) * sizeof(std::uint32_t), data.place());
        new_index_.resize(vertices.count(), kUnused);
    }
    compact(mesh, vertices);
    for (const std::uint32_t corner : corners) new_index_[corner] = kUnused;

    degenerate_triangles_ += drop_degenerate_triangles(mesh);
    if (mesh.triangles.empty()) return std::nullopt;
    if (const std::size_t repaired = repair_normals(mesh); repaired > 0) {
        document_.warn(
            fmt::format("{} vertex normals of meshes[{}] are zero or not finite: taken from the faces",
                        repaired, mesh_index));
    }
    decoded.centre = recentre(mesh);
    if (joints != nullptr) decoded.centre += joints->anchor;
    return decoded;
}

}  // namespace aoscore::gltf
