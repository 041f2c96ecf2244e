#pragma once

#include <filesystem>

namespace aoscore {

/// Throws file_error for an EXR of which an attribute claims more bytes than the file has: OpenEXR would make
/// room for them, and fill it, before it reads. Files of other formats, and what else is wrong, are left to
/// those who read them.
void require_plausible_exr_header(const std::filesystem::path& path);

}  // namespace aoscore
