#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace aoscore {

/// The program's version, as in CMakeLists.txt and CHANGELOG.md.
std::string_view version();

/// Returns the content of a file. Throws file_error when it cannot be read or is larger than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{2} << 30);

/// Lets `write` produce a file under a temporary name (the folder is created when missing), then brings it to
/// `path` as PendingFile does. Nothing is left when `write` throws.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// Replaces the content of a file; messages call it `named`. Throws file_error.
void fill_file(const std::filesystem::path& file, std::string_view content,
               const std::filesystem::path& named);

}  // namespace aoscore
