#pragma once

#include "results/results.h"

#include <filesystem>
#include <string>

namespace aoscore {

/// The key of a page's contents: the results without their time and use of caches, the page's styles, scripts
/// and sections, and `code`, the digest of the code that makes pages.
std::string page_key(const Results& results, const std::string& code);

/// Whether the page at `path` was made under this key; false where there is none.
bool is_page_of(const std::filesystem::path& path, const std::string& key);

/// A comment that ends a page and names its key.
std::string page_key_comment(const std::string& key);

}  // namespace aoscore
