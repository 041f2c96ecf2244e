#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/method/method.h"

#include <glm/glm.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// What a processor computes a pass from, row 0 at the top.
struct ProcessorInput {
    const CameraFrame* frame = nullptr;
    const ImageF* linear_depth = nullptr;      ///< metres; the far plane's on background
    const Image<glm::vec4>* normal = nullptr;  ///< xyz: view space, unit, turned to the camera
    float background_depth = 0;
};

/// An algorithm that computes a pass on the processor, for what no fragment shader can carry from pixel to
/// pixel. A pass names it in place of a fragment: {"processor": "line_sweep"}.
struct Processor {
    std::string_view id;
    std::set<std::string> parameters;  ///< that it reads: a method with such a pass must declare them
    /// Visibility of every pixel, 1 on background.
    ImageF (*compute)(const ProcessorInput& input, const ParameterValues& parameters);
    /// Texture fetches a pixel.
    double (*fetches)(const ParameterValues& parameters);
};
/// The one table of processors.
const std::vector<Processor>& processors();

}  // namespace aoscore
