#pragma once

#include <filesystem>
#include <string_view>

namespace aoscore {

/// Where a command writes its results and their page: the folder that was named, else reports/out/`name`.
std::filesystem::path results_folder(const std::filesystem::path& named, std::string_view name);

}  // namespace aoscore
