#pragma once

#include <cstddef>
#include <filesystem>

namespace aoscore::importer {

/// Confines this process before it looks at the first byte of a file. It may take memory for a file of that
/// size (2 GiB, and 40 times the file), and see the scene's folder alone (by Landlock, where the kernel has
/// it). It ends with the process that started it, and leaves Ctrl-C to that.
void confine(const std::filesystem::path& folder, std::size_t file_bytes);

/// Grants processor time for one more file of so many bytes. SIGXCPU ends a process that takes longer.
void allow_time_for(std::size_t bytes);

}  // namespace aoscore::importer
