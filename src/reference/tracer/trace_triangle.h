#pragma once

#include <glm/glm.hpp>

#include <array>

namespace aoscore {

/// One triangle in trace space.
struct TraceTriangle {
    std::array<glm::dvec3, 3> corners;
    double area() const {
        return glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])) / 2;
    }
    /// From a point to the nearest point of the triangle, which may be degenerate.
    double distance(const glm::dvec3& point) const;
};

}  // namespace aoscore
