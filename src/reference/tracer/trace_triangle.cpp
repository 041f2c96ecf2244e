#include "reference/tracer/trace_triangle.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

double distance_to_edge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& point) {
    const glm::dvec3 edge = to - from;
    const double square = glm::dot(edge, edge);
    const double along = square > 0 ? std::clamp(glm::dot(point - from, edge) / square, 0.0, 1.0) : 0;
    return glm::distance(point, from + along * edge);
}

}  // namespace

double TraceTriangle::distance(const glm::dvec3& point) const {
    const auto& [a, b, c] = corners;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, point - from), normal) >= 0;
    };
    if (length > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return std::abs(glm::dot(point - a, normal)) / length;
    return std::min(
        {distance_to_edge(a, b, point), distance_to_edge(b, c, point), distance_to_edge(c, a, point)});
}

}  // namespace aoscore
