#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace aoscore {

/// Loads a scene's file of any format, in metres with y up where the file or the user states units and axes.
/// Bounds are measured; the views are the file's own cameras. load_scene() adds id, digest, origin and the
/// choice of views. Throws file_error.
Scene load_file(const std::filesystem::path& path, const LoadOptions& options);

/// Warns of a scene whose unit nobody states: not its file, not the user, not a view file made for it.
void warn_of_unknown_unit(Scene& scene, const LoadOptions& options);

}  // namespace aoscore
