#include "reference/tracer/open_space.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// Surroundings with more triangles than this are given up: to look at them would cost more than rays.
constexpr std::size_t kMostTriangles = 256;

}  // namespace

bool OpenSpace::blocks(std::size_t triangle, const UpwardPoint& point, double reach_m) const {
    const auto& [a, b, c] = nearby_[triangle].corners;
    const double highest =
        std::max({glm::dot(point.normal, a - point.position), glm::dot(point.normal, b - point.position),
                  glm::dot(point.normal, c - point.position)});
    if (highest <= -point.margin_m) return false;
    const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    const glm::dvec3 gap = glm::max(glm::dvec3(0), glm::max(low - point.position, point.position - high));
    const double reach = reach_m + point.margin_m;
    return glm::dot(gap, gap) <= reach * reach;
}

std::vector<char> OpenSpace::prove(const std::vector<UpwardPoint>& points, double reach_m) {
    std::vector<char> open(points.size(), 0);
    // Rays that reach through half of the scene have all of it around them.
    const bool too_far = reach_m > scene_.diagonal_m() / 2 && scene_.triangle_count() > kMostTriangles;
    if (points.empty() || too_far) return open;
    glm::dvec3 low = points[0].position, high = low;
    double margin_m = 0;
    for (const UpwardPoint& p : points) {
        low = glm::min(low, p.position);
        high = glm::max(high, p.position);
        margin_m = std::max(margin_m, p.margin_m);
    }
    const double radius_m = reach_m + 2 * margin_m + glm::distance(low, high) / 2;
    if (!scene_.triangles_near((low + high) / 2.0, radius_m, kMostTriangles, within_reach_, nearby_))
        return open;
    std::size_t last_blocker = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        // The triangle that blocks one point mostly blocks the next.
        bool blocked = last_blocker < nearby_.size() && blocks(last_blocker, points[p], reach_m);
        for (std::size_t t = 0; t < nearby_.size() && !blocked; ++t) {
            blocked = blocks(t, points[p], reach_m);
            if (blocked) last_blocker = t;
        }
        open[p] = blocked ? 0 : 1;
    }
    return open;
}

}  // namespace aoscore
