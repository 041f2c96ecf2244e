#include "scene/builtin/mesh_builder.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace aoscore::builtin {
namespace {

struct PositionHash {
    std::size_t operator()(const glm::vec3& p) const {
        std::uint64_t h = 0;
        for (int axis = 0; axis < 3; ++axis) {
            h = (h ^ std::bit_cast<std::uint32_t>(p[axis])) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }
};

glm::vec3 to_float(const glm::dvec3& p) {
    return glm::vec3(p) + glm::vec3(0);
}  // + 0 turns -0 into 0

double corner_angle(const glm::dvec3& at, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 u = b - at, v = c - at;
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

struct Face {
    glm::uvec3 welded;
    glm::vec2 uv[3];
    glm::dvec3 normal;
    double angle[3];
};

/// Corner number `corner` of face number `face`.
struct Use {
    std::uint32_t face;
    int corner;
};

/// The faces of the corners, three a face, with their points numbered; `points` gets the points.
std::vector<Face> weld(const std::vector<MeshBuilder::Corner>& corners, std::vector<glm::vec3>& points) {
    std::unordered_map<glm::vec3, std::uint32_t, PositionHash> numbers;
    std::vector<Face> faces;
    faces.reserve(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        Face face;
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) {
            const MeshBuilder::Corner& corner = corners[i + static_cast<std::size_t>(k)];
            const glm::vec3 position = to_float(corner.position);
            const auto [entry, added] =
                numbers.try_emplace(position, static_cast<std::uint32_t>(points.size()));
            if (added) points.push_back(position);
            face.welded[k] = entry->second;
            face.uv[k] = corner.uv;
            p[k] = position;
        }
        const glm::dvec3 doubled_area = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double longest =
            std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
        // Poles of lathed shapes collapse to points, and rounding to float may flatten a needle.
        if (glm::length(doubled_area) <= 1e-6 * longest * longest) continue;
        face.normal = glm::normalize(doubled_area);
        for (int k = 0; k < 3; ++k) face.angle[k] = corner_angle(p[k], p[(k + 1) % 3], p[(k + 2) % 3]);
        faces.push_back(face);
    }
    return faces;
}

/// The mean normal of those faces at a point whose normals are this near to `normal`, weighted by their
/// angles.
glm::vec3 smooth_normal(const std::vector<Face>& faces, const std::vector<Use>& uses,
                        const glm::dvec3& normal, double least_cosine) {
    glm::dvec3 sum(0);
    for (const Use& use : uses) {
        const Face& face = faces[use.face];
        if (glm::dot(face.normal, normal) >= least_cosine) sum += face.normal * face.angle[use.corner];
    }
    return to_float(glm::normalize(sum));
}

/// The vertex from number `first` on with this normal and texture coordinate; a new one where there is none.
std::size_t vertex_for(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv,
                       std::size_t first, Mesh& mesh) {
    for (std::size_t vertex = first; vertex < mesh.positions.size(); ++vertex) {
        if (mesh.normals[vertex] == normal && mesh.texcoords[vertex] == uv) return vertex;
    }
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.texcoords.push_back(uv);
    return mesh.positions.size() - 1;
}

}  // namespace

void MeshBuilder::triangle(const Point& a, const Point& b, const Point& c) {
    corners_.insert(corners_.end(), {{a}, {b}, {c}});
}

void MeshBuilder::triangle(const Point& a, const Point& b, const Point& c, const glm::vec2& uv_a,
                           const glm::vec2& uv_b, const glm::vec2& uv_c) {
    corners_.insert(corners_.end(), {{a, uv_a}, {b, uv_b}, {c, uv_c}});
}

void MeshBuilder::quad(const Point& a, const Point& b, const Point& c, const Point& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

void MeshBuilder::append(const MeshBuilder& other, const glm::dmat4& this_from_other) {
    assert(glm::determinant(this_from_other) > 0);
    corners_.reserve(corners_.size() + other.corners_.size());
    for (const Corner& corner : other.corners_) {
        corners_.push_back({Point(this_from_other * glm::dvec4(corner.position, 1)), corner.uv});
    }
}

Mesh MeshBuilder::finish(int material, double crease_rad, bool with_texcoords) const {
    std::vector<glm::vec3> points;
    std::vector<Face> faces = weld(corners_, points);
    if (!with_texcoords) {
        for (Face& face : faces) std::ranges::fill(face.uv, glm::vec2(0));
    }
    std::vector<std::vector<Use>> uses(points.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) uses[faces[f].welded[k]].push_back({f, k});
    }

    Mesh mesh;
    mesh.material = material;
    mesh.triangles.resize(faces.size());
    const double least_cosine = std::cos(crease_rad);
    for (std::uint32_t point = 0; point < points.size(); ++point) {
        const std::size_t first = mesh.positions.size();
        for (const Use& use : uses[point]) {
            const std::size_t vertex = vertex_for(
                points[point], smooth_normal(faces, uses[point], faces[use.face].normal, least_cosine),
                faces[use.face].uv[use.corner], first, mesh);
            mesh.triangles[use.face][use.corner] = static_cast<std::uint32_t>(vertex);
        }
    }
    if (!with_texcoords) mesh.texcoords.clear();
    return mesh;
}

}  // namespace aoscore::builtin
