#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore {

/// Direction `i` of `count` spread evenly over the cap around the unit vector `axis` whose edge has cosine
/// `least_cosine` (-1: all directions), by the golden angle.
inline glm::dvec3 spread_direction(const glm::dvec3& axis, double least_cosine, int i, int count) {
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, axis)), y = glm::cross(axis, x);
    const double cosine = 1 - (1 - least_cosine) * (i + 0.5) / count;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    return axis * cosine + (x * std::cos(angle) + y * std::sin(angle)) * sine;
}

}  // namespace aoscore
