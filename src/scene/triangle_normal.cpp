#include "scene/scene.h"

namespace aoscore {

glm::dvec3 triangle_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    return length > 0 ? cross / length : glm::dvec3(0.0);
}

}  // namespace aoscore
