#pragma once

#include <filesystem>

namespace aoscore {

/// Makes the page of a tuning, folder/index.html, from folder/tune.json and the presets beside it alone.
/// Returns its path. Throws file_error when they are missing or of another version.
std::filesystem::path write_tuning_page(const std::filesystem::path& results_folder);

}  // namespace aoscore
