#pragma once

#include <filesystem>

namespace aoscore {

/// Makes one self-contained HTML page, folder/index.html, from folder/results.json and the images beside it
/// alone. Returns its path. Throws file_error when the results are missing or of another version.
std::filesystem::path write_report(const std::filesystem::path& results_folder);

}  // namespace aoscore
