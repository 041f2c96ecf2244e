#pragma once

#include "image/image_file.h"

#include <filesystem>

namespace aoscore {

/// Whether the first part of an EXR has channels of lower resolution than the picture, as files of luminance
/// and chroma have. False for what is no readable EXR.
bool is_subsampled_exr(const std::filesystem::path& path);

/// Reads such a file: the values of channels of lower resolution are repeated. OpenImageIO refuses these
/// files. Throws file_error as read_image() does.
ImageFile read_subsampled_exr(const std::filesystem::path& path);

}  // namespace aoscore
