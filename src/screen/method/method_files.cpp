#include "screen/method/method_files.h"

#include "core/error.h"
#include "core/folders.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

namespace fs = std::filesystem;

fs::path shader_library() {
    return data_dir() / "shaders";
}

bool lies_in(const fs::path& path, const fs::path& folder) {
    const fs::path inner = fs::weakly_canonical(path), outer = fs::weakly_canonical(folder);
    return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

void require_own_file(const fs::path& file, const fs::path& method_folder, const std::string& where) {
    if (lies_in(file, method_folder) || lies_in(file, shader_library())) return;
    throw file_error(fmt::format("\"{}\" lies outside", file.string()), where,
                     fmt::format("a file in {} or {}", method_folder.string(), shader_library().string()));
}

}  // namespace aoscore
