#include "reference/tracer/reach.h"

#include <array>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

/// Triangles that are left out lie this much farther away than they need, as a part of all lengths that the
/// rounding of points and rays to float32 is a part of. Twice the part of its depth by which a seen point may
/// lie off the triangle that the ray met, which is far more than rounding does.
constexpr double kMarginPart = 2e-4;

/// The half space in front of or behind a plane: points of it have dot(outwards, p) + offset <= 0.
struct HalfSpace {
    glm::dvec3 outwards;  ///< unit
    double offset_m;
};

/// Those whose intersection is all that the frame may show, view space.
std::array<HalfSpace, 6> sides_of(const CameraFrame& frame) {
    const Camera& camera = frame.camera();
    const auto across = [&](const glm::dvec3& axis, double half_extent) -> HalfSpace {
        if (camera.projection == Camera::Projection::orthographic) return {axis, -half_extent};
        return {glm::normalize(axis + glm::dvec3(0, 0, half_extent)), 0};
    };
    const double half_width = 1 / frame.clip_from_view()[0][0];
    const double half_height = 1 / frame.clip_from_view()[1][1];
    return {across({-1, 0, 0}, half_width),    across({1, 0, 0}, half_width),
            across({0, -1, 0}, half_height),   across({0, 1, 0}, half_height),
            HalfSpace{{0, 0, 1}, camera.near}, HalfSpace{{0, 0, -1}, -camera.far}};
}

/// In every coordinate the farthest that a box of these half edges extends from its centre.
glm::dvec3 extent(const glm::dmat3& half_edges) {
    return glm::abs(half_edges[0]) + glm::abs(half_edges[1]) + glm::abs(half_edges[2]);
}

}  // namespace

Reach::Reach(const Scene& scene) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<PlacedBox> of_meshes;
    for (const Mesh& mesh : scene.meshes) {
        glm::dvec3 low(kInfinity), high(-kInfinity);
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, glm::dvec3(p));
            high = glm::max(high, glm::dvec3(p));
        }
        PlacedBox& box = of_meshes.emplace_back();
        if (mesh.positions.empty()) continue;
        box.centre = (low + high) / 2.0;
        for (int axis = 0; axis < 3; ++axis) box.half_edges[axis][axis] = (high[axis] - low[axis]) / 2;
    }
    bounds_ = {glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    for (const Instance& instance : scene.instances) {
        const PlacedBox& of_mesh = of_meshes[static_cast<std::size_t>(instance.mesh)];
        PlacedBox& box = boxes_.emplace_back();
        box.centre = glm::dvec3(instance.scene_from_mesh * glm::dvec4(of_mesh.centre, 1));
        box.half_edges = glm::dmat3(instance.scene_from_mesh) * of_mesh.half_edges;
        bounds_.low = glm::min(bounds_.low, box.centre - extent(box.half_edges));
        bounds_.high = glm::max(bounds_.high, box.centre + extent(box.half_edges));
    }
}

std::vector<char> Reach::instances(const CameraFrame& frame, double reach_m) const {
    std::vector<char> within(boxes_.size(), 1);
    if (boxes_.empty() || !std::isfinite(reach_m)) return within;
    const double camera_m = glm::distance(frame.camera().position, bounds_.centre());
    const double farthest_m = reach_m + kMarginPart * (reach_m + bounds_.diagonal() + camera_m);
    const std::array<HalfSpace, 6> sides = sides_of(frame);
    const glm::dmat3 turn(frame.view_from_world());
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const glm::dvec3 centre(frame.view_from_world() * glm::dvec4(boxes_[i].centre, 1));
        const glm::dmat3 half_edges = turn * boxes_[i].half_edges;
        for (const HalfSpace& side : sides) {
            // Of the box's corners, the one that lies the least outside.
            const glm::dvec3 along = glm::abs(side.outwards * half_edges);
            const double outside_m =
                glm::dot(side.outwards, centre) + side.offset_m - (along.x + along.y + along.z);
            if (outside_m > farthest_m) within[i] = 0;
        }
    }
    return within;
}

}  // namespace aoscore
