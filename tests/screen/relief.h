#pragma once

#include "scene/camera.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace aoscore::testing {

/// A surface seen straight from above, with the elevation of its horizon over the plane of the shaded point.
struct Relief {
    std::string name;
    Scene scene;
    int width = 0, height = 0;
    std::vector<glm::ivec2> pixels;                   // all of them see the same horizon
    std::function<double(double azimuth)> elevation;  // radians, >= 0
    bool endless = false;
    static constexpr double kFloor = -20;  ///< z of the shaded points
};

/// A floor before an endless wall `ratio` times as high as it is away.
Relief wall(double ratio, int height);
/// The middle of a round pit whose rim is seen at this zenith angle.
Relief pit(double rim_degrees);
/// An orthographic camera that looks straight down.
CameraFrame from_above(int width, int height);

}  // namespace aoscore::testing
