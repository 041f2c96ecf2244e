#include "scene/automatic_view.h"

#include "core/threads.h"
#include "scene/depth_range.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace aoscore {
namespace {

constexpr double kFovy = 60 * std::numbers::pi / 180;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a ray meets first.
struct Sight {
    double distance = kInfinity;
    bool front_face = false;  ///< seen from the side that its winding calls the front
};

/// Brute force on purpose: a few hundred rays, once, in scenes without a camera. An acceleration structure
/// lives in the reference room, which this one does not know.
class RayProbe {
  public:
    explicit RayProbe(const Scene& scene) {
        // Of a scene too large for that, every n-th triangle stands for all: enough to tell far from near.
        constexpr std::size_t kMaxTriangles = 2'000'000;
        const std::size_t step = scene.triangle_count / kMaxTriangles + 1;
        std::size_t count = 0;
        for (const Instance& instance : scene.instances) {
            const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
            // A mirroring transform turns the winding round (glTF 2.0, "Instantiation").
            const bool mirrors = glm::determinant(glm::dmat3(instance.scene_from_mesh)) < 0;
            for (const glm::uvec3& t : mesh.triangles) {
                if (count++ % step != 0) continue;
                const auto vertex = [&](unsigned i) {
                    return glm::dvec3(instance.scene_from_mesh * glm::dvec4(mesh.positions[i], 1));
                };
                const glm::dvec3 a = vertex(t.x), b = vertex(t.y), c = vertex(t.z);
                triangles_.push_back(mirrors ? Triangle{a, c - a, b - a} : Triangle{a, b - a, c - a});
            }
        }
    }

    /// How many rays each of `shares` equal parts of the work may cost.
    int rays(int shares) const {
        constexpr std::size_t kTests = 20'000'000;
        const std::size_t per_share = kTests / (triangles_.size() * static_cast<std::size_t>(shares) + 1);
        return static_cast<int>(std::clamp<std::size_t>(per_share, 5, 63));
    }

    /// The first surface along a unit direction. Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle
    /// Intersection, 1997; surfaces are two-sided.
    Sight first_surface(const glm::dvec3& from, const glm::dvec3& direction) const {
        Sight sight;
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
            if (along > 0 && along < sight.distance) sight = {along, determinant > 0};
        }
        return sight;
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

/// Whether a point is in a room rather than in the open or within a solid thing.
bool is_room(const RayProbe& probe, const glm::dvec3& point) {
    const int rays = probe.rays(4);
    int fronts = 0;
    for (int i = 0; i < rays; ++i) {
        if (probe.first_surface(point, spread_direction({0, 1, 0}, -1, i, rays)).front_face) ++fronts;
    }
    return fronts * 10 >= rays * 7;
}

/// What a camera sees: the median distance within a cone of 30 degrees, at most `limit`.
double median_sight(const RayProbe& probe, const Camera& camera, double limit, int rays) {
    std::vector<double> distances;
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 forward = camera.target - camera.position;
        const glm::dvec3 direction = spread_direction(forward, std::cos(kFovy / 2), i, rays);
        distances.push_back(std::min(probe.first_surface(camera.position, direction).distance, limit));
    }
    std::nth_element(distances.begin(), distances.begin() + rays / 2, distances.end());
    return distances[static_cast<std::size_t>(rays) / 2];
}

Camera inside_camera(const RayProbe& probe, const Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    std::vector<Camera> candidates;
    for (const int axis : {0, 2}) {
        for (const double sign : {1.0, -1.0}) {
            for (const double along : {0.1, 0.35}) {
                for (const double across : {0.5, 0.35, 0.65}) {
                    const int other = 2 - axis;
                    Camera camera;
                    camera.position[axis] =
                        (sign > 0 ? bounds.low : bounds.high)[axis] + sign * along * size[axis];
                    camera.position[other] = bounds.low[other] + across * size[other];
                    camera.position.y = bounds.low.y + size.y / 3;
                    camera.target = camera.position;
                    camera.target[axis] += sign;
                    candidates.push_back(camera);
                }
            }
        }
    }
    const int rays = probe.rays(static_cast<int>(candidates.size()));
    std::vector<double> sights(candidates.size());
    parallel_for(candidates.size(), [&](std::size_t i) {
        sights[i] = median_sight(probe, candidates[i], bounds.diagonal(), rays);
    });
    // The first of the best, within what rounding could swap.
    const double best = *std::max_element(sights.begin(), sights.end());
    const auto chosen =
        std::find_if(sights.begin(), sights.end(), [&](double s) { return s >= best * 0.999; });
    return candidates[static_cast<std::size_t>(chosen - sights.begin())];
}

Camera outside_camera(const Bounds& bounds) {
    Camera camera;
    const double radius = bounds.diagonal() / 2;
    camera.target = bounds.centre();
    camera.position =
        bounds.centre() + glm::normalize(glm::dvec3(0.8, 0.5, 1.0)) * (radius / std::sin(kFovy / 2));
    return camera;
}

}  // namespace

View automatic_view(const Scene& scene) {
    const RayProbe probe(scene);
    View view;
    view.id = "auto";
    view.kind = View::Kind::automatic;
    view.source = "automatic";
    const bool inside = is_room(probe, scene.bounds.centre());
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
