#pragma once

#include "scene/scene.h"
#include "store/artifact_store.h"

#include <string>
#include <vector>

namespace aoscore {

/// The views of a scene for a choice (see choose_views()), for pictures of this width to height. Automatic
/// views are made where there are no others or the choice begins with "auto", and kept in the store.
std::vector<View> wanted_views(const Scene& scene, const LoadOptions& loaded_with, const std::string& choice,
                               double aspect, const ArtifactStore& store);

/// Says that views of wanted_views() are automatic because the scene has no camera, and how to name one;
/// empty where it has.
std::string no_camera_text(const Scene& scene, const std::vector<View>& views);

}  // namespace aoscore
