// What EmbreeScene finds through a pixel. Float32 leaves open which of two surfaces that meet under it lies
// in front: double precision decides.
#include "reference/tracer/embree/embree_scene.h"
#include "reference/tracer/embree/first_triangles.h"
#include "scene/cofactors.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

namespace aoscore {
namespace {

/// Rounding units (2^-24 of the largest coordinate) by which a ray's start is lifted off its surface, and how
/// much more where an instance's transform is applied to the ray in float32. Eight times what tilted planes
/// of any orientation needed in experiments.
constexpr double kOffsetUnits = 32;
constexpr double kInstanceOffsetFactor = 4;
/// Where Embree's distance and that to the triangle's plane differ by more than this part, the plane is seen
/// so flat that the distance to it is ill-conditioned.
constexpr double kFlatPart = 1e-4;

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Whether a line passes through a triangle or meets its boundary.
bool passes_through(const TraceTriangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 a = triangle.corners[0] - origin, b = triangle.corners[1] - origin,
                     c = triangle.corners[2] - origin;
    const double ab = glm::dot(direction, glm::cross(a, b)), bc = glm::dot(direction, glm::cross(b, c)),
                 ca = glm::dot(direction, glm::cross(c, a));
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Where a ray meets the plane of a triangle of this normal, in lengths of its direction; empty where that is
/// ill-conditioned, because it is not near `distance`.
std::optional<double> distance_to_plane(const TraceTriangle& triangle, const glm::dvec3& normal,
                                        const glm::dvec3& origin, const glm::dvec3& direction,
                                        double distance) {
    const double t = glm::dot(normal, triangle.corners[0] - origin) / glm::dot(normal, direction);
    if (!(std::abs(t - distance) <= kFlatPart * distance)) return std::nullopt;
    return t;
}

}  // namespace

MetTriangle EmbreeScene::nearest_of(const std::vector<MetTriangle>& tied, const glm::dvec3& origin,
                                    const glm::dvec3& direction) const {
    /// Less is nearer. Where two triangles coincide, the one that the scene names first.
    struct Rank {
        bool misses;  ///< the ray misses the triangle, where rounding let it meet it
        double distance;
        std::size_t instance;
        unsigned triangle;
        auto operator<=>(const Rank&) const = default;
    };
    const auto rank_of = [&](const MetTriangle& met) -> Rank {
        const Placement& placement = placements_[met.placement];
        const TraceTriangle one = triangle(placement, met.triangle);
        const auto& [a, b, c] = one.corners;
        const double distance =
            distance_to_plane(one, triangle_normal(a, b, c), origin, direction, met.distance)
                .value_or(met.distance);
        return {!passes_through(one, origin, direction), distance, placement.number, met.triangle};
    };
    return *std::ranges::min_element(tied, std::ranges::less{}, rank_of);
}

bool EmbreeScene::first_hit(const CameraFrame::Ray& ray, double near, double far, SurfaceHit& hit) const {
    const glm::dvec3 origin = ray.origin - centre_;
    const glm::vec3 o(origin), d(ray.direction);
    const std::vector<MetTriangle> first = first_triangles(
        scene_.get(),
        {o.x, o.y, o.z, static_cast<float>(near), d.x, d.y, d.z, 0, static_cast<float>(far), ~0u, 0, 0});
    if (first.empty()) return false;
    const MetTriangle met = first.size() == 1 ? first[0] : nearest_of(first, origin, ray.direction);

    const Placement& placement = placements_[met.placement];
    const TraceGeometry& geometry = *placement.geometry;
    const glm::uvec3 corner = geometry.triangles[met.triangle];
    const TraceTriangle seen = triangle(placement, met.triangle);
    const auto& [a, b, c] = seen.corners;
    const double u = met.u, v = met.v;

    hit.normal = triangle_normal(a, b, c);
    if (hit.normal == glm::dvec3(0)) hit.normal = -glm::normalize(ray.direction);
    const double facing = glm::dot(hit.normal, ray.direction);
    if (facing > 0) hit.normal = -hit.normal;
    hit.front = (facing > 0) == placement.mirrors;

    // The plane of the triangle in double precision puts the point exactly under the pixel; at grazing
    // angles, where that is ill-conditioned, the barycentric point stays inside the triangle.
    if (const std::optional<double> t =
            distance_to_plane(seen, hit.normal, origin, ray.direction, met.distance)) {
        hit.position = origin + *t * ray.direction;
        hit.depth = *t;
    } else {
        hit.position = (1 - u - v) * a + u * b + v * c;
        hit.depth = met.distance;
    }
    const double extent =
        std::max({largest(a - hit.position), largest(b - hit.position), largest(c - hit.position)});
    hit.offset_m = kOffsetUnits * 0x1p-24 * (largest(hit.position) + extent);
    if (placement.is_instance) hit.offset_m *= kInstanceOffsetFactor;

    hit.shading_normal = hit.normal;
    if (!geometry.normals.empty()) {
        const glm::dvec3 smooth = (1 - u - v) * glm::dvec3(geometry.normals[corner.x]) +
                                  u * glm::dvec3(geometry.normals[corner.y]) +
                                  v * glm::dvec3(geometry.normals[corner.z]);
        glm::dvec3 turned = cofactors(glm::dmat3(placement.trace_from_geometry)) * smooth;
        const double length = glm::length(turned);
        if (length > 0) {
            turned /= length;
            hit.shading_normal = glm::dot(turned, hit.normal) < 0 ? -turned : turned;
        }
    }
    return true;
}

}  // namespace aoscore
