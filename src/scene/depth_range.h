#pragma once

#include "scene/scene.h"

namespace aoscore {

struct DepthRange {
    double near = 0;
    double far = 0;
};

/// The depth range a camera needs for a scene, metres along its line of sight. Far is a twentieth behind the
/// bounds' furthest corner unless `stated_far` is nearer; near is as stated but never below 1e-5 of far (0
/// stands for a plane that is not stated). `camera` and `bounds` share their coordinates; only the camera's
/// position, target and projection count.
DepthRange useful_depth_range(const Camera& camera, const Bounds& bounds, double stated_near,
                              double stated_far);

}  // namespace aoscore
