#include "framing/outline_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

/// The camera's distance and place that one axis of the picture needs.
struct AxisFit {
    double back = 0, place = 0;
};

/// Fits one axis. A point at `at`, `back` behind the origin along the line of sight, is within the angle of a
/// camera at (place, camera_back) when |at - place| <= tangent * (camera_back - back).
AxisFit fit_axis(const std::vector<glm::dvec3>& points, const glm::dvec3& axis, const glm::dvec3& backwards,
                 double tangent) {
    double right = -std::numeric_limits<double>::infinity(), left = right;
    for (const glm::dvec3& p : points) {
        const double at = glm::dot(p, axis), back = glm::dot(p, backwards);
        right = std::max(right, tangent * back + at);
        left = std::max(left, tangent * back - at);
    }
    return {(right + left) / (2 * tangent), (right - left) / 2};
}

}  // namespace

Camera fit_outline(const std::vector<glm::dvec3>& points, const glm::dvec3& forward, const glm::dvec3& up,
                   double fovy_rad, double aspect, double margin) {
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up)), above = glm::cross(right, forward);
    const double tangent = std::tan(fovy_rad / 2) * (1 - margin);
    const AxisFit across = fit_axis(points, right, -forward, tangent * aspect);
    const AxisFit upwards = fit_axis(points, above, -forward, tangent);
    const double back = std::max(across.back, upwards.back);
    double nearest = -std::numeric_limits<double>::infinity(), furthest = -nearest;
    for (const glm::dvec3& p : points) {
        nearest = std::max(nearest, glm::dot(p, -forward));
        furthest = std::min(furthest, glm::dot(p, -forward));
    }
    Camera camera;
    camera.fovy_rad = fovy_rad;
    camera.up = up;
    camera.position = right * across.place + above * upwards.place - forward * back;
    camera.target = camera.position + forward * (back - (nearest + furthest) / 2);
    return camera;
}

}  // namespace aoscore
