#pragma once

#include "scene/scene.h"
#include "store/artifact_store.h"

#include <string>
#include <vector>

namespace aoscore {

/// The views of a scene that a choice stands for (see choose_views()), for pictures of this width to height.
/// Automatic ones are made where nothing else is there or the choice begins with "auto", and kept in the
/// store.
std::vector<View> wanted_views(const Scene& scene, const LoadOptions& loaded_with, const std::string& choice,
                               double aspect, const ArtifactStore& store);

}  // namespace aoscore
