#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace aoscore::gltf {

/// Reads a glTF 2.0 file (.gltf with its buffers and images, or .glb): geometry in the rest pose, instances,
/// cut-outs, cameras and warnings. load_scene() adds id, digest, origin and the choice of views. Coordinates
/// are the file's; bounds and triangle_count are filled. Throws file_error that names file and place.
Scene load_gltf(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace aoscore::gltf
