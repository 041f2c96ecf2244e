#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace aoscore {

/// Writes a scene as binary glTF 2.0: all instances of its meshes in metres, y up, relative to Scene::origin,
/// every material two-sided, with the cut-outs' alpha. Other colour textures are left out: occlusion needs
/// none. load_scene() finds the same surfaces in it. Throws file_error where it cannot be written.
void write_glb(const Scene& scene, const std::filesystem::path& path);

}  // namespace aoscore
