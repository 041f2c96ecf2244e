#pragma once

#include "image/image_file.h"

#include <filesystem>
#include <optional>

namespace aoscore {

/// Reads a plain EXR file by OpenEXR alone, which is loaded in an instant and keeps no second copy of the
/// pixels: one flat part in scan lines, whose data window is its display window, with floats of full
/// resolution in channels named R, G, B, A, X, Y, Z or <layer>.<one of these>. All that the file holds is as
/// OpenImageIO gives it, but that only texts and matrices are attributes. Empty for every other file, and for
/// one that is broken: those are OpenImageIO's to read, or to say what is wrong with them.
std::optional<ImageFile> read_plain_exr(const std::filesystem::path& path);

}  // namespace aoscore
