#pragma once

#include "results/results.h"
#include "scene/scene.h"

#include <string>

namespace aoscore {

/// The facts of a view that are known before anything is rendered: scene, camera in world coordinates, size.
ViewRecord describe_view(const Scene& scene, const View& view, const CameraFrame& frame,
                         const std::string& key);

}  // namespace aoscore
