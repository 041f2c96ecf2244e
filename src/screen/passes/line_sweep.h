#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/method/method.h"

#include <glm/glm.hpp>

#include <set>
#include <string>

namespace aoscore {

/// What a sweep works on, row 0 at the top.
struct SweepInput {
    const CameraFrame* frame = nullptr;
    const ImageF* linear_depth = nullptr;      ///< metres; the far plane's on background
    const Image<glm::vec4>* normal = nullptr;  ///< xyz: view space, unit, turned to the camera
    float background_depth = 0;
};

/// The parameters it reads.
const std::set<std::string>& line_sweep_parameters();

/// Visibility without a radius, by sweeping lines over the picture: the occluders behind a pixel on its line
/// form a convex hull, kept on a stack, whose tangent is the horizon (Timonen, Line-Sweep Ambient Obscurance,
/// 2013). Linear in the pixels for any reach. 1 on background; the same for any number of threads.
ImageF line_sweep(const SweepInput& input, const ParameterValues& parameters);

}  // namespace aoscore
