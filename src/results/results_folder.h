#pragma once

#include <filesystem>
#include <string_view>

namespace aoscore {

/// The folder for a command's results and their page: the one that the user named, else reports/out/`name`.
std::filesystem::path results_folder(const std::filesystem::path& named, std::string_view name);

}  // namespace aoscore
