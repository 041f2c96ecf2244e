#include "scene/gltf/meshes.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "scene/gltf/accessors.h"
#include "scene/gltf/primitive_topology.h"
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

bool allows_quantization(const Document& document) {
    const auto& used = document.model->extensionsUsed;
    return std::find(used.begin(), used.end(), "KHR_mesh_quantization") != used.end();
}

/// Whether glTF (with KHR_mesh_quantization where `quantized`) allows that component type for the attribute.
bool type_allowed(const Accessor& accessor, int components, bool quantized) {
    if (accessor.components() != components) return false;
    const int type = accessor.component_type();
    if (type == TINYGLTF_COMPONENT_TYPE_FLOAT) return true;
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return false;
    if (quantized) return true;
    // Texture coordinates alone may be normalised integers without the extension.
    return components == 2 && accessor.normalized() &&
           (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
}

std::optional<Accessor> find_attribute(const Document& document, const tinygltf::Primitive& primitive,
                                       const std::string& place, const std::string& name, int components) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return std::nullopt;
    Accessor accessor(document, found->second);
    if (!type_allowed(accessor, components, allows_quantization(document))) {
        throw file_error(accessor.name() + " has a type that it may not have", place + ".attributes." + name,
                         "floats; integers where extensionsUsed has KHR_mesh_quantization");
    }
    return accessor;
}

/// The vertex of each corner, in the order of the primitive's topology.
std::vector<std::uint32_t> read_corners(Document& document, const tinygltf::Primitive& primitive,
                                        const std::string& place, std::size_t vertices) {
    constexpr std::size_t kBytesPerCorner =
        4 + 12;  // its index, and its share of a triangle and its vertices
    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
        document.budget.take(vertices * kBytesPerCorner, place);
        corners.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) corners[i] = static_cast<std::uint32_t>(i);
        return corners;
    }
    const Accessor indices(document, primitive.indices);
    const int type = indices.component_type();
    if (indices.components() != 1 ||
        (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
         type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        throw file_error(indices.name() + " has a type that it may not have", place + ".indices",
                         "unsigned integer scalars");
    }
    document.budget.take(indices.count() * kBytesPerCorner, place);
    corners.resize(indices.count());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = indices.unsigned_integer(i);
        if (corners[i] >= vertices) {
            throw file_error(fmt::format("index {} is vertex {} of {}", i, corners[i], vertices),
                             fmt::format("{}: {}", document.where, indices.name()));
        }
    }
    return corners;
}

/// Moves the mesh to its own centre on the axes where it lies far off for its size. Nothing is lost by that:
/// there, the coordinates are so close to each other that float32 holds their differences.
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

std::vector<DecodedMesh> MeshReader::read(int mesh) {
    std::vector<DecodedMesh> decoded;
    const std::size_t count = document_.model->meshes[static_cast<std::size_t>(mesh)].primitives.size();
    for (std::size_t primitive = 0; primitive < count; ++primitive) {
        throw_if_interrupted();
        if (auto result = read_primitive(mesh, primitive)) decoded.push_back(std::move(*result));
    }
    return decoded;
}

std::optional<DecodedMesh> MeshReader::read_primitive(int mesh_index, std::size_t primitive_index) {
    const auto& primitive =
        document_.model->meshes[static_cast<std::size_t>(mesh_index)].primitives[primitive_index];
    const std::string place =
        fmt::format("{}: meshes[{}].primitives[{}]", document_.where, mesh_index, primitive_index);
    if (primitive.mode != -1 && primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        document_.warn("primitives of points and lines are left out: they have no surface");
        return std::nullopt;
    }
    const auto positions = find_attribute(document_, primitive, place, "POSITION", 3);
    if (!positions) {
        document_.warn("primitives without POSITION are left out");
        return std::nullopt;
    }
    const tinygltf::Accessor& position_source =
        document_.model->accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    if (position_source.minValues.empty() || position_source.maxValues.empty()) {
        document_.warn("POSITION accessors lack min and max (not legal in glTF): taken from the data");
    }
    const auto normals = find_attribute(document_, primitive, place, "NORMAL", 3);
    const int material = materials_.index_of(primitive.material);
    const TexcoordSource& texcoord_source = materials_.texcoords[static_cast<std::size_t>(material)];
    std::optional<Accessor> texcoords;
    if (texcoord_source.wanted) {
        texcoords = find_attribute(document_, primitive, place, texcoord_source.attribute, 2);
        if (!texcoords) {
            document_.warn(fmt::format("primitives lack {}, which their material samples: taken as 0, 0",
                                       texcoord_source.attribute));
        }
    }
    for (const std::optional<Accessor>* attribute : {&normals, &std::as_const(texcoords)}) {
        if (*attribute && (*attribute)->count() != positions->count()) {
            throw file_error(fmt::format("{} has {} elements, POSITION has {}", (*attribute)->name(),
                                         (*attribute)->count(), positions->count()),
                             place + ".attributes");
        }
    }

    const std::vector<std::uint32_t> corners = read_corners(document_, primitive, place, positions->count());
    if (corners.size() < 3 || (primitive.mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)) {
        document_.warn("primitives have left-over indices that make no triangle");
    }
    DecodedMesh decoded;
    Mesh& mesh = decoded.mesh;
    mesh.material = material;
    mesh.triangles = triangles_of(corners, primitive.mode);

    // Many primitives may share one long accessor: keep the vertices that this one uses, in the order of use.
    if (new_index_.size() < positions->count()) {
        document_.budget.take((positions->count() - new_index_.size()) * sizeof(std::uint32_t), place);
        new_index_.resize(positions->count(), kUnused);
    }
    const auto use_vertex = [&](std::uint32_t old_index) {
        std::uint32_t& index = new_index_[old_index];
        if (index != kUnused) return index;
        index = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::vec3 p = positions->vector<3>(old_index);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            throw file_error(fmt::format("position {} is not finite", old_index),
                             fmt::format("{}: {}", document_.where, positions->name()));
        }
        mesh.positions.push_back(p);
        if (normals) mesh.normals.push_back(normals->vector<3>(old_index));
        if (texcoord_source.wanted) {
            const glm::dvec3 uv1(texcoords ? texcoords->vector<2>(old_index) : glm::vec2(0), 1.0);
            mesh.texcoords.emplace_back(texcoord_source.uv_from_texcoord * uv1);
        }
        return index;
    };
    for (glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) triangle[corner] = use_vertex(triangle[corner]);
    }
    for (const std::uint32_t corner : corners) new_index_[corner] = kUnused;

    degenerate_triangles_ += drop_degenerate_triangles(mesh);
    if (mesh.triangles.empty()) return std::nullopt;
    if (const std::size_t repaired = repair_normals(mesh); repaired > 0) {
        document_.warn(
            fmt::format("{} vertex normals of meshes[{}] are zero or not finite: taken from the faces",
                        repaired, mesh_index));
    }
    decoded.centre = recentre(mesh);
    return decoded;
}

}  // namespace aoscore::gltf
