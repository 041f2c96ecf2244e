#include "builtin_table.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

/// Of two faces in the same plane over the same area (z-fighting), the rasteriser and the ray tracer may
/// choose different ones. No built-in scene may have any.
namespace aoscore {
namespace {

using Corners = std::array<glm::dvec2, 3>;

struct Face {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal;
    double offset;
    int mesh;
};

constexpr double kSamePlane_m = 1e-5;
constexpr double kSameDirection = 1e-4;  // sine of the angle between the planes
constexpr double kTouching_m = 2e-5;     // overlaps narrower than this are shared edges

std::vector<Face> faces_of(const Scene& scene) {
    std::vector<Face> faces;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (scene.materials[static_cast<std::size_t>(mesh.material)].is_cutout()) continue;
        for (const glm::uvec3& t : mesh.triangles) {
            Face face;
            face.mesh = instance.mesh;
            for (int k = 0; k < 3; ++k) {
                face.corners[static_cast<std::size_t>(k)] =
                    glm::vec3(instance.scene_from_mesh * glm::dvec4(mesh.positions[t[k]], 1));
            }
            face.normal = triangle_normal(face.corners[0], face.corners[1], face.corners[2]);
            // Both sides of a plane count as one plane.
            const glm::dvec3 n = face.normal;
            const double sign =
                n.x > 1e-3 || (n.x > -1e-3 && (n.y > 1e-3 || (n.y > -1e-3 && n.z > 0))) ? 1 : -1;
            face.normal *= sign;
            face.offset = glm::dot(face.normal, face.corners[0]);
            faces.push_back(face);
        }
    }
    return faces;
}

bool boxes_meet(const Corners& a, const Corners& b) {
    const auto low = [](const Corners& c) { return glm::min(c[0], glm::min(c[1], c[2])); };
    const auto high = [](const Corners& c) { return glm::max(c[0], glm::max(c[1], c[2])); };
    return glm::all(glm::lessThan(low(a), high(b))) && glm::all(glm::lessThan(low(b), high(a)));
}

/// The depth of overlap of two triangles in one plane: the least along all edge normals, <= 0 if apart.
double overlap(const Corners& a, const Corners& b) {
    double least = 1e30;
    for (const Corners* triangle : {&a, &b}) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 edge = (*triangle)[(k + 1) % 3] - (*triangle)[k];
            const glm::dvec2 axis = glm::normalize(glm::dvec2(-edge.y, edge.x));
            double low_a = 1e30, high_a = -1e30, low_b = 1e30, high_b = -1e30;
            for (std::size_t i = 0; i < 3; ++i) {
                low_a = std::min(low_a, glm::dot(a[i], axis));
                high_a = std::max(high_a, glm::dot(a[i], axis));
                low_b = std::min(low_b, glm::dot(b[i], axis));
                high_b = std::max(high_b, glm::dot(b[i], axis));
            }
            least = std::min(least, std::min(high_a, high_b) - std::max(low_a, low_b));
        }
    }
    return least;
}

bool same_plane(const Face& a, const Face& b) {
    if (glm::length(glm::cross(a.normal, b.normal)) > kSameDirection) return false;
    return std::all_of(b.corners.begin(), b.corners.end(), [&](const glm::dvec3& p) {
        return std::abs(glm::dot(a.normal, p) - a.offset) < kSamePlane_m;
    });
}

Corners flattened(const Face& face) {
    const int drop = std::abs(face.normal.x) > 0.6 ? 0 : std::abs(face.normal.y) > 0.6 ? 1 : 2;
    Corners flat;
    for (std::size_t k = 0; k < 3; ++k) {
        flat[k] = {face.corners[k][(drop + 1) % 3], face.corners[k][(drop + 2) % 3]};
    }
    return flat;
}

std::string text(const Face& f) {
    std::string out = "mesh " + std::to_string(f.mesh) + ": ";
    for (const glm::dvec3& c : f.corners) {
        out += "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ", " + std::to_string(c.z) + ") ";
    }
    return out;
}

class CoplanarFaces : public testing::EveryBuiltin {};

TEST_P(CoplanarFaces, NeverOverlap) {
    const std::vector<Face> faces = faces_of(GetParam().generate());
    // Sorted by plane offset within cells of the direction; a face is entered in every cell near its
    // direction.
    using Cell = std::array<int, 3>;
    std::map<Cell, std::vector<std::size_t>> cells;
    constexpr double kCell = 0.01;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        std::array<std::array<int, 2>, 3> near;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = faces[i].normal[axis] / kCell;
            near[static_cast<std::size_t>(axis)] = {static_cast<int>(std::floor(at - 0.02)),
                                                    static_cast<int>(std::floor(at + 0.02))};
        }
        for (int code = 0; code < 8; ++code) {
            Cell cell;
            bool repeated = false;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const bool second = (code >> axis) & 1;
                repeated |= second && near[axis][0] == near[axis][1];
                cell[axis] = near[axis][second ? 1 : 0];
            }
            if (!repeated) cells[cell].push_back(i);
        }
    }
    std::set<std::pair<int, int>> reported;  // once a pair of meshes
    for (auto& [cell, members] : cells) {
        std::sort(members.begin(), members.end(),
                  [&](std::size_t a, std::size_t b) { return faces[a].offset < faces[b].offset; });
        std::vector<Corners> flat;
        for (const std::size_t member : members) flat.push_back(flattened(faces[member]));
        for (std::size_t i = 0; i < members.size(); ++i) {
            const Face& a = faces[members[i]];
            for (std::size_t k = i + 1; k < members.size(); ++k) {
                const Face& b = faces[members[k]];
                if (b.offset - a.offset > 2e-3) break;  // offsets differ a little where directions do
                if (!boxes_meet(flat[i], flat[k]) || !same_plane(a, b)) continue;
                if (overlap(flat[i], flat[k]) <= kTouching_m) continue;
                if (reported.emplace(std::minmax(a.mesh, b.mesh)).second)
                    ADD_FAILURE() << text(a) << "\nand " << text(b);
            }
        }
    }
}

AOSCORE_FOR_EVERY_BUILTIN(CoplanarFaces);

}  // namespace
}  // namespace aoscore
