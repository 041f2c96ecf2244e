#pragma once

#include <cstddef>
#include <filesystem>

namespace aoscore::importer {

/// Takes from this process what reading a file does not need, before the first of its bytes is looked at:
/// memory beyond what a file of that size may take (2 GiB, and 40 times the file), all of the file system but
/// the scene's folder (Landlock, where the kernel has it), and its life when the one who started it ends.
/// Ctrl-C is left to that one.
void confine(const std::filesystem::path& folder, std::size_t file_bytes);

/// Grants processor time for one more file of so many bytes. What takes longer hangs, and is ended by
/// SIGXCPU.
void allow_time_for(std::size_t bytes);

}  // namespace aoscore::importer
