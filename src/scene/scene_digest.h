#pragma once

#include "scene/scene.h"

#include <string>

namespace aoscore {

/// The content digest of everything that changes a picture: geometry, transforms, origin, base colours and
/// cut-outs with their textures. Views, names, and textures that only colour are not in it: a truth does not
/// depend on them.
std::string scene_digest(const Scene& scene);

}  // namespace aoscore
