#pragma once

#include "image/image_file.h"

#include <filesystem>

namespace aoscore {

/// Whether the first part of an EXR has channels of lower resolution than the picture, as files of luminance
/// and chroma have. False for a file that is no readable EXR.
bool is_subsampled_exr(const std::filesystem::path& path);

/// Reads such a file, which OpenImageIO refuses: it repeats the values of channels of lower resolution.
/// Throws file_error as read_image() does.
ImageFile read_subsampled_exr(const std::filesystem::path& path);

}  // namespace aoscore
