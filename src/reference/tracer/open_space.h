#pragma once

#include "reference/tracer/ray_tracer.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// A point that rays leave upwards: into the half space above its tangent plane.
struct UpwardPoint {
    glm::dvec3 position;  ///< where rays start, trace space
    glm::dvec3 normal;    ///< geometric, unit
    double margin_m =
        0;  ///< triangles that reach less than this below the plane count as above it, against rounding
};

/// Proves points open: no triangle within reach has a part above the tangent plane. What is proven is exact;
/// what is not may be open all the same, because triangles are judged by their boxes and crowded places are
/// given up.
class OpenSpace {
  public:
    /// `within_reach`: one flag an instance of the scene, see Reach: what cannot be met is not looked at.
    OpenSpace(const RayTracer& scene, const std::vector<char>& within_reach)
        : scene_(scene), within_reach_(within_reach) {}

    /// One flag a point: 1 where no ray of at most `reach_m` (infinity allowed) can hit anything. The points
    /// should lie close together: they share one look at their surroundings.
    std::vector<char> prove(const std::vector<UpwardPoint>& points, double reach_m);

  private:
    bool blocks(std::size_t triangle, const UpwardPoint& point, double reach_m) const;

    const RayTracer& scene_;
    const std::vector<char>& within_reach_;
    std::vector<TraceTriangle> nearby_;
};

}  // namespace aoscore
