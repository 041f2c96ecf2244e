#pragma once

#include "scene/scene.h"

namespace aoscore::gltf {

/// Makes solid every cut-out of which no point can be cut, by its factor, its texture's texels and its
/// meshes' vertices: tracer and rasteriser then skip the test. Its meshes lose their alphas, and their
/// texture coordinates unless `keep_textures`.
void make_uncut_solid(Scene& scene, bool keep_textures);

}  // namespace aoscore::gltf
