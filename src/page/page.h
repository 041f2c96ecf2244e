#pragma once

#include "results/results.h"

#include <filesystem>
#include <string>

namespace aoscore {

/// Throws file_error when a library that pages need is not installed. It is called before long work.
void require_page_parts();

/// Makes one self-contained HTML page, folder/index.html, from the results and the images beside their
/// results.json alone. `everything` keeps raw outputs and occlusion by cause in large pages too. `key`, where
/// there is one, is written into it (see page_key()). Returns its path. Throws file_error when an image is
/// missing.
std::filesystem::path write_page(const Results& results, const std::filesystem::path& results_folder,
                                 bool everything = false, const std::string& key = {});

/// The same with the results of folder/results.json. Throws file_error when they cannot be read.
std::filesystem::path write_page(const std::filesystem::path& results_folder);

/// Writes the page of these results with their key, unless `shown`, a page that exists or not, shows these
/// very results made by the same `code` (see page_key()).
void write_page_unless_shown(const std::filesystem::path& results_folder, const std::filesystem::path& shown,
                             const std::string& code);

}  // namespace aoscore
