#pragma once

#include "scene/import/import_formats.h"
#include "scene/import/plain_scene.h"

#include <filesystem>

namespace aoscore::imported {

/// Reads an OBJ, FBX, PLY or STL file in a process of its own, aoscore-import beside this program, within
/// limits: a crash or a hang there is a file_error here. Triangles without area are left out and counted,
/// normals are unit. Coordinates are the file's own. Throws file_error that names the file and the place in
/// it.
PlainScene load_import(const std::filesystem::path& file, Format format, bool albedo_textures);

}  // namespace aoscore::imported
