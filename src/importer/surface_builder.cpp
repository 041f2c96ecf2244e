#include "importer/surface_builder.h"

#include "core/error.h"
#include "importer/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace aoscore::importer {
namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t bits) {
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
}

std::uint64_t hash_of(const Corner& corner) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) hash = mixed(hash, std::bit_cast<std::uint64_t>(corner.position[i]));
    for (int i = 0; i < 3; ++i) hash = mixed(hash, std::bit_cast<std::uint32_t>(corner.normal[i]));
    for (int i = 0; i < 2; ++i) hash = mixed(hash, std::bit_cast<std::uint32_t>(corner.texcoord[i]));
    return hash;
}

bool same(const Corner& a, const Corner& b) {
    return a.position == b.position && a.normal == b.normal && a.texcoord == b.texcoord;
}

void check_position(const glm::dvec3& p, std::size_t face) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(p[axis]) <= kLargest)) {
            throw file_error(fmt::format("holds the coordinate {}", p[axis]), fmt::format("face {}", face),
                             "a finite float32 number");
        }
    }
}

/// The middle of the vertices on those axes on which they lie more than 64 times their extent from the
/// origin, which costs six bits of a float32.
glm::dvec3 far_off_middle(const std::vector<Corner>& vertices) {
    constexpr double kFarOff = 64;
    glm::dvec3 low = vertices[0].position, high = low;
    for (const Corner& vertex : vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    const glm::dvec3 extent = high - low, middle = (low + high) / 2.0;
    const double largest = std::max({extent.x, extent.y, extent.z});
    glm::dvec3 centre(0);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(middle[axis]) > kFarOff * largest) centre[axis] = middle[axis];
    }
    return centre;
}

}  // namespace

void SurfaceBuilder::grow_table() {
    table_.assign(std::max<std::size_t>(64, 2 * table_.size()), 0);
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
        std::size_t slot = hash_of(vertices_[i]);
        while (table_[slot & (table_.size() - 1)] != 0) ++slot;
        table_[slot & (table_.size() - 1)] = i + 1;
    }
}

std::uint32_t SurfaceBuilder::vertex_of(const Corner& corner) {
    if (2 * vertices_.size() >= table_.size()) grow_table();
    for (std::size_t slot = hash_of(corner);; ++slot) {
        std::uint32_t& entry = table_[slot & (table_.size() - 1)];
        if (entry == 0) {
            vertices_.push_back(corner);
            entry = static_cast<std::uint32_t>(vertices_.size());
            return entry - 1;
        }
        if (same(vertices_[entry - 1], corner)) return entry - 1;
    }
}

void SurfaceBuilder::add(std::span<const Corner> polygon, std::size_t face) {
    corner_positions_.clear();
    for (const Corner& corner : polygon) {
        check_position(corner.position, face);
        corner_positions_.push_back(corner.position);
    }
    for (const glm::uvec3& triangle : triangulate(corner_positions_)) {
        glm::uvec3 vertices;
        for (int i = 0; i < 3; ++i) vertices[i] = vertex_of(polygon[triangle[i]]);
        triangles_.push_back(vertices);
    }
}

SurfaceBuilder::Built SurfaceBuilder::take() {
    Built built;
    built.centre = far_off_middle(vertices_);
    built.mesh.material = attributes_.material;
    built.mesh.triangles = std::exchange(triangles_, {});
    for (const Corner& vertex : vertices_) {
        built.mesh.positions.emplace_back(vertex.position - built.centre);
        if (attributes_.normals) built.mesh.normals.push_back(vertex.normal);
        if (attributes_.texcoords) built.mesh.texcoords.push_back(vertex.texcoord);
    }
    vertices_.clear();
    table_.clear();
    return built;
}

}  // namespace aoscore::importer
