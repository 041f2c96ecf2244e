#include "core/folders.h"

#include "core/error.h"
#include "core/processes/program_path.h"

#include <cstdlib>
#include <optional>
#include <system_error>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The folder that an environment variable names. The XDG specification has relative paths ignored; so does
/// this.
std::optional<fs::path> named_by(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return fs::path(value);
}

/// A folder of the user's by the XDG Base Directory Specification 0.8.
fs::path user_folder(const char* variable, const char* below_home) {
    if (const auto folder = named_by(variable); folder && folder->is_absolute()) return *folder / "aoscore";
    const auto home = named_by("HOME");
    if (!home)
        throw usage_error(
            "HOME is not set, so that there is no folder of the user's (AOSCORE_CACHE names one)");
    return *home / below_home / "aoscore";
}

fs::path shared_data() {
    const fs::path data = fs::path("share") / "aoscore";
    std::error_code ec;
    for (fs::path folder = program_path().parent_path(); folder != folder.root_path();
         folder = folder.parent_path()) {
        if (fs::is_directory(folder / data, ec)) return fs::canonical(folder / data);
    }
    if (fs::path installed = "/usr" / data; fs::is_directory(installed, ec)) return installed;
    throw internal_error("its shaders, scenes and pages are missing: there is no share/aoscore above it",
                         program_path().string());
}

bool is_source_tree(const fs::path& data) {
    return fs::exists(data / "CMakeLists.txt");
}

std::vector<fs::path> of_user_and_program(const char* name) {
    std::vector<fs::path> folders;
    if (named_by("HOME") || named_by("XDG_DATA_HOME"))
        folders.push_back(user_folder("XDG_DATA_HOME", ".local/share") / name);
    folders.push_back(data_dir() / name);
    return folders;
}

}  // namespace

fs::path data_dir() {
    if (const auto named = named_by("AOSCORE_DATA")) return *named;
    static const fs::path found = shared_data();
    return found;
}

fs::path cache_dir() {
    if (const auto named = named_by("AOSCORE_CACHE")) return *named;
    const fs::path data = data_dir();
    if (is_source_tree(data)) return data / "references" / "cache";
    return user_folder("XDG_CACHE_HOME", ".cache");
}

void work_in(const fs::path& folder) {
    for (const char* variable : {"AOSCORE_CACHE", "AOSCORE_DATA"}) {
        if (const auto named = named_by(variable)) setenv(variable, fs::absolute(*named).c_str(), 1);
    }
    fs::current_path(folder);
}

fs::path results_dir() {
    const fs::path data = data_dir();
    return is_source_tree(data) ? data / "reports" / "out" : fs::path("aoscore-out");
}

std::vector<fs::path> scene_folders() {
    return of_user_and_program("scenes");
}

std::vector<fs::path> contestant_folders() {
    return of_user_and_program("contestants");
}

}  // namespace aoscore
