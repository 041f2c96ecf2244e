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
};

}  // namespace aoscore
