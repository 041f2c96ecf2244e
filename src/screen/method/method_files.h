#pragma once

#include <filesystem>
#include <string>

namespace aoscore {

/// The program's own folder shaders/, whose files every method may include.
std::filesystem::path shader_library();

/// Whether the path, all links followed, lies below the folder.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Throws file_error where a method's file lies neither in the method's folder nor in the shader library, all
/// links followed: a shader's messages must not quote other files. `where` is the place that names it.
void require_own_file(const std::filesystem::path& file, const std::filesystem::path& method_folder,
                      const std::string& where);

}  // namespace aoscore
