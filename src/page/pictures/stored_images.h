#pragma once

#include "image/image_file.h"

#include <filesystem>
#include <string>

namespace aoscore {

/// The path of a file that the results name. Throws file_error for a path outside of their folder.
std::filesystem::path stored_path(const std::filesystem::path& folder, const std::string& file);

/// The channel of that name. Throws file_error listing the channels when there is none; `path` is the file's.
const ImageF& channel_of(const ImageFile& file, const std::filesystem::path& path, const std::string& name);

}  // namespace aoscore
