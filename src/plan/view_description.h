#pragma once

#include "results/results.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace aoscore {

/// The record of a view before anything is rendered: scene, camera in world coordinates, size.
ViewRecord describe_view(const Scene& scene, const View& view, const CameraFrame& frame,
                         const std::string& key);

/// These views of the scene as the text of a view file for it (see scenes/README.md).
std::string view_file_text(const Scene& scene, const std::vector<View>& views);

}  // namespace aoscore
