#pragma once

#include "scene/scene.h"

namespace aoscore::gltf {

/// Makes solid every cut-out of which no point is ever cut, for all that its factor, its texture's texels and
/// its meshes' vertices say: no tracer or rasteriser need ask then. Its meshes lose their alphas, and their
/// texture coordinates unless `keep_textures`.
void make_uncut_solid(Scene& scene, bool keep_textures);

}  // namespace aoscore::gltf
