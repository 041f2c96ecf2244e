#pragma once

#include <filesystem>

namespace aoscore {

/// Makes the page of a stress test, folder/index.html, from folder/stress.json and the images beside it
/// alone. Returns its path. Throws file_error when they are missing or of another version.
std::filesystem::path write_stress_page(const std::filesystem::path& results_folder);

}  // namespace aoscore
