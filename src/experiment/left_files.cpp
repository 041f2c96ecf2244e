#include "experiment/left_files.h"

#include "core/error.h"

#include <string>
#include <system_error>

namespace aoscore {

namespace fs = std::filesystem;

namespace {

/// The pictures that results name, in views/ and cells/ alone: a results.json of others may name any file.
std::set<fs::path> named_pictures(const Results& results) {
    std::set<fs::path> pictures;
    const auto add = [&](const std::string& file) {
        const fs::path path(file), parent = path.parent_path();
        if (path.has_filename() && (parent == "views" || parent == "cells")) pictures.insert(path);
    };
    for (const ViewRecord& view : results.views) {
        add(view.truth_file);
        add(view.gbuffer_file);
        if (view.light) add(view.light->file);
    }
    for (const CellRecord& cell : results.cells) {
        add(cell.image_file);
        add(cell.lit_file);
    }
    return pictures;
}

}  // namespace

std::set<fs::path> pictures_in(const fs::path& folder) {
    std::error_code ec;
    if (!fs::exists(folder / "results.json", ec)) return {};
    try {
        return named_pictures(read_results(folder));
    } catch (const Error&) {
        return {};
    }
}

void remove_left_pictures(const fs::path& folder, const std::set<fs::path>& earlier, const Results& results) {
    const std::set<fs::path> named = named_pictures(results);
    std::error_code ec;
    for (const fs::path& picture : earlier) {
        // A link in place of the folder would lead to files of others.
        if (named.contains(picture) || fs::is_symlink(folder / picture.parent_path(), ec)) continue;
        fs::remove(folder / picture, ec);
    }
}

}  // namespace aoscore
