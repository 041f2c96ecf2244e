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

/// The inputs from which a processor computes a pass, row 0 at the top.
struct ProcessorInput {
    const CameraFrame* frame = nullptr;
    const ImageF* linear_depth = nullptr;      ///< metres; the far plane's on background
    const Image<glm::vec4>* normal = nullptr;  ///< xyz: view space, unit, facing the camera
    float background_depth = 0;
};

/// An algorithm that computes a pass on the processor, for data that no fragment shader can carry from pixel
/// to pixel. A pass names it in place of a fragment: {"processor": "line_sweep"}.
struct Processor {
    std::string_view id;
    std::set<std::string> parameters;  ///< parameters it reads, which a method with such a pass must declare
    /// Computes the visibility of every pixel, 1 on background.
    ImageF (*compute)(const ProcessorInput& input, const ParameterValues& parameters);
    /// The number of texture fetches a pixel.
    double (*fetches)(const ParameterValues& parameters);
};
/// The one table of processors.
const std::vector<Processor>& processors();

}  // namespace aoscore
