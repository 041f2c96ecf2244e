#include "scene/automatic_view.h"

#include "scene/depth_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace aoscore {
namespace {

constexpr double kFovy = 60 * std::numbers::pi / 180;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Brute force on purpose: a few hundred rays, once, in scenes without a camera. An acceleration structure
/// lives in the reference room, which this one does not know.
class RayProbe {
  public:
    explicit RayProbe(const Scene& scene) {
        triangles_.reserve(scene.triangle_count);
        for (const Instance& instance : scene.instances) {
            const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
            for (const glm::uvec3& t : mesh.triangles) {
                const auto vertex = [&](unsigned i) {
                    return glm::dvec3(instance.scene_from_mesh * glm::dvec4(mesh.positions[i], 1));
                };
                const glm::dvec3 a = vertex(t.x);
                triangles_.push_back({a, vertex(t.y) - a, vertex(t.z) - a});
            }
        }
    }

    /// How many rays `share` parts of the whole work may cost.
    int rays(int share) const {
        constexpr std::size_t kTests = 60'000'000;
        const std::size_t per_part = kTests / (triangles_.size() * static_cast<std::size_t>(share) + 1);
        return static_cast<int>(std::clamp<std::size_t>(per_part, 8, 64));
    }

    /// Distance to the first surface along a unit direction, infinite for none. Moeller and Trumbore, Fast,
    /// Minimum Storage Ray/Triangle Intersection, 1997; surfaces are two-sided.
    double distance(const glm::dvec3& from, const glm::dvec3& direction) const {
        double nearest = kInfinity;
        for (const Triangle& t : triangles_) {
            const glm::dvec3 p = glm::cross(direction, t.edge2);
            const double determinant = glm::dot(t.edge1, p);
            if (determinant == 0) continue;
            const glm::dvec3 s = from - t.corner;
            const double u = glm::dot(s, p) / determinant;
            if (u < 0 || u > 1) continue;
            const glm::dvec3 q = glm::cross(s, t.edge1);
            const double v = glm::dot(direction, q) / determinant;
            if (v < 0 || u + v > 1) continue;
            const double along = glm::dot(t.edge2, q) / determinant;
            if (along > 0) nearest = std::min(nearest, along);
        }
        return nearest;
    }

  private:
    struct Triangle {
        glm::dvec3 corner, edge1, edge2;
    };
    std::vector<Triangle> triangles_;
};

/// Direction `i` of `count` spread evenly over the cap around `axis` whose edge has cosine `least_cosine`, by
/// the golden angle.
glm::dvec3 spread_direction(const glm::dvec3& axis, double least_cosine, int i, int count) {
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, axis)), y = glm::cross(axis, x);
    const double cosine = 1 - (1 - least_cosine) * (i + 0.5) / count;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    return axis * cosine + (x * std::cos(angle) + y * std::sin(angle)) * sine;
}

bool encloses(const RayProbe& probe, const glm::dvec3& point, int share) {
    const int rays = probe.rays(share);
    int hits = 0;
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 direction = spread_direction({0, 1, 0}, -1, i, rays);
        if (probe.distance(point, direction) < kInfinity) ++hits;
    }
    return hits * 10 >= rays * 7;
}

/// What a camera sees: the median distance in a cone of 30 degrees, at most `limit`.
double median_sight(const RayProbe& probe, const glm::dvec3& from, const glm::dvec3& direction, double limit,
                    int share) {
    const int rays = probe.rays(share);
    std::vector<double> distances;
    for (int i = 0; i < rays; ++i) {
        const double distance =
            probe.distance(from, spread_direction(direction, std::cos(kFovy / 2), i, rays));
        distances.push_back(std::min(distance, limit));
    }
    std::nth_element(distances.begin(), distances.begin() + rays / 2, distances.end());
    return distances[static_cast<std::size_t>(rays) / 2];
}

Camera inside_camera(const RayProbe& probe, const Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    const double eye = bounds.low.y + size.y / 3;
    const std::array<double, 3> kAlong = {0.08, 0.25, 0.5};
    const std::array<double, 3> kAcross = {0.35, 0.5, 0.65};
    constexpr int kCandidates = 2 * 2 * 3 * 3;
    Camera best;
    double best_sight = -1;
    for (const int axis : {0, 2}) {
        for (const double sign : {1.0, -1.0}) {
            for (const double along : kAlong) {
                for (const double across : kAcross) {
                    const int other = 2 - axis;
                    glm::dvec3 from(0, eye, 0), forward(0.0);
                    from[axis] = sign > 0 ? bounds.low[axis] + along * size[axis]
                                          : bounds.high[axis] - along * size[axis];
                    from[other] = bounds.low[other] + across * size[other];
                    forward[axis] = sign;
                    const double sight = median_sight(probe, from, forward, bounds.diagonal(), kCandidates);
                    if (sight > best_sight * 1.001) {
                        best_sight = sight;
                        best.position = from;
                        best.target = from + forward;
                    }
                }
            }
        }
    }
    return best;
}

Camera outside_camera(const Bounds& bounds) {
    Camera camera;
    const double radius = bounds.diagonal() / 2;
    const glm::dvec3 from_centre = glm::normalize(glm::dvec3(0.8, 0.5, 1.0));
    camera.target = bounds.centre();
    camera.position = bounds.centre() + from_centre * (radius / std::sin(kFovy / 2));
    return camera;
}

}  // namespace

View automatic_view(const Scene& scene) {
    const RayProbe probe(scene);
    constexpr int kWorkForEnclosure = 4;
    View view;
    view.id = "auto";
    view.source = "automatic";
    const bool inside = encloses(probe, scene.bounds.centre(), kWorkForEnclosure);
    view.camera = inside ? inside_camera(probe, scene.bounds) : outside_camera(scene.bounds);
    view.camera.fovy_rad = kFovy;
    // Inside, a wall may be close by; outside, everything is at least this far away.
    const double stated_near = inside ? 0.001 * scene.bounds.diagonal() : 0.4 * scene.bounds.diagonal();
    const DepthRange range = useful_depth_range(view.camera, scene.bounds, stated_near, 0);
    view.camera.near = range.near;
    view.camera.far = range.far;
    return view;
}

}  // namespace aoscore
