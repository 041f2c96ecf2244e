#pragma once

#include <filesystem>
#include <string_view>

namespace aoscore {

/// The folder for a command's results and their page: the one that the user named, else `name` in results_dir() of core/folders.h.
std::filesystem::path results_folder(const std::filesystem::path& named, std::string_view name);

}  // namespace aoscore
