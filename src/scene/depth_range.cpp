#include "scene/depth_range.h"

#include <algorithm>

namespace aoscore {

DepthRange useful_depth_range(const Camera& camera, const Bounds& bounds, double stated_near,
                              double stated_far) {
    // With 24 or 32 bits of window depth, steps at the far end are then still below a ten-thousandth of the
    // depth.
    constexpr double kNearPerFar = 1e-5;
    // The far plane lies so far behind the last corner that, with the least near plane, the corner's window
    // depth stays 8 steps of float32 below 1, the background's: a surface nearer to the far plane would be
    // lost.
    constexpr double kBehind = 1.05;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    double furthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                           (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                           (corner & 4) != 0 ? bounds.high.z : bounds.low.z);
        furthest = std::max(furthest, glm::dot(p - camera.position, forward));
    }
    DepthRange range;
    // A camera that looks away from everything still needs a range.
    range.far = std::max({furthest * kBehind, stated_near * 2, bounds.diagonal() * kNearPerFar});
    if (stated_far > 0) range.far = std::min(range.far, stated_far);
    range.near = std::max(stated_near, range.far * kNearPerFar);
    // Happens only where the stated far is almost the stated near.
    if (!(range.far > range.near)) range.far = range.near * 2;
    return range;
}

}  // namespace aoscore
