#pragma once

#include "page/index/index_contents.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace aoscore {

/// Writes folder/index.html: a ranking over all scenes with intervals over scenes, every scene and
/// contestant, every cell with filters, and links to the pages of the results. Returns its path. Throws
/// file_error where it cannot be written.
std::filesystem::path write_index_page(const IndexContents& contents, const std::filesystem::path& folder,
                                       const std::string& command, std::uint64_t seed);

}  // namespace aoscore
