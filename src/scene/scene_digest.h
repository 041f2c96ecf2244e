#pragma once

#include "scene/scene.h"

#include <string>

namespace aoscore {

/// The digest of everything that changes a picture: geometry, transforms, origin, base colours and cut-outs
/// with their textures. It leaves out views, names, and textures that only give colour: no truth depends on
/// them.
std::string scene_digest(const Scene& scene);

}  // namespace aoscore
