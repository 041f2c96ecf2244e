#pragma once

#include <filesystem>

namespace aoscore {

/// Writes a file's bytes into an existing device or pipe. A pipe is waited for until somebody reads it.
/// Throws file_error, interrupted_error on Ctrl-C.
void write_through(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace aoscore
