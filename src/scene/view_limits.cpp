#include "scene/view_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

bool is_length(double value) {
    return value >= static_cast<double>(std::numeric_limits<float>::min()) && is_float32(value);
}

}  // namespace

bool is_float32(double value) {
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

std::string view_fault(const Camera& camera, const Bounds& bounds) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double value : {camera.position[axis], camera.target[axis], camera.up[axis]}) {
            if (!is_float32(value)) return fmt::format("{:g} is no finite float32", value);
        }
    }
    for (const double value : {camera.near, camera.far, camera.half_height}) {
        if (!is_length(value)) return fmt::format("{:g} m is no normal float32", value);
    }
    const double diagonal = bounds.diagonal(), furthest = kFurthestCamera * diagonal;
    const auto is_near = [&](const glm::dvec3& p) { return glm::distance(p, bounds.centre()) <= furthest; };
    if (!(diagonal > 0) || (is_near(camera.position) && is_near(camera.target))) return "";
    return fmt::format(
        "its camera or target is {:.3g} m from the middle of the scene; at most {:g} times the scene's "
        "diagonal "
        "are possible, {:.3g} m",
        std::max(glm::distance(camera.position, bounds.centre()),
                 glm::distance(camera.target, bounds.centre())),
        kFurthestCamera, furthest);
}

}  // namespace aoscore
