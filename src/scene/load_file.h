#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace aoscore {

/// A scene's file of any format, in metres with y up as far as it or the user says so. Bounds are measured;
/// the views are the file's own cameras. Id, digest, origin and the choice of views are load_scene()'s.
/// Throws file_error.
Scene load_file(const std::filesystem::path& path, const LoadOptions& options);

/// Warns of a scene whose file states no unit, unless the user does, or views of it that were made for it.
void warn_of_unknown_unit(Scene& scene, const LoadOptions& options);

}  // namespace aoscore
