#include "importer/scene_folder.h"

#include "core/error.h"
#include "core/files.h"
#include "importer/confinement.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <system_error>
#include <vector>

namespace aoscore::importer {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxCopyBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxSubfolders = 256;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return text;
}

/// The parts of a name from any system, without "." and all before the last "..".
std::vector<std::string> parts_of(const std::string& name) {
    std::vector<std::string> parts{""};
    for (const char c : name) {
        if (c == '/' || c == '\\') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    const auto last_up = std::find(parts.rbegin(), parts.rend(), "..");
    parts.erase(parts.begin(), last_up.base());
    std::erase_if(parts, [](const std::string& part) { return part.empty() || part == "."; });
    return parts;
}

/// The entry of a folder with that name, or else one that differs in letter case alone.
std::optional<fs::path> entry_of(const fs::path& folder, const std::string& name) {
    std::error_code ec;
    if (fs::exists(folder / name, ec)) return folder / name;
    std::vector<fs::path> alike;
    for (fs::directory_iterator entry(folder, ec), end; !ec && entry != end; entry.increment(ec)) {
        if (lower(entry->path().filename().string()) == lower(name)) alike.push_back(entry->path());
    }
    if (alike.empty()) return std::nullopt;
    return *std::min_element(alike.begin(), alike.end());
}

std::optional<fs::path> below(const fs::path& folder, std::span<const std::string> parts) {
    fs::path path = folder;
    for (const std::string& part : parts) {
        const std::optional<fs::path> entry = entry_of(path, part);
        if (!entry) return std::nullopt;
        path = *entry;
    }
    return path;
}

std::vector<fs::path> subfolders(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code ec;
    for (fs::directory_iterator entry(folder, ec), end; !ec && entry != end; entry.increment(ec)) {
        if (entry->is_directory(ec)) found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end());
    if (found.size() > kMaxSubfolders) found.resize(kMaxSubfolders);
    return found;
}

/// Whether the path is a regular file, and no symbolic link leads out of the folder.
bool is_within(const fs::path& folder, const fs::path& path) {
    std::error_code ec;
    const fs::path real = fs::canonical(path, ec);
    if (ec || !fs::is_regular_file(real, ec)) return false;
    const auto [end_of_folder, rest] = std::mismatch(folder.begin(), folder.end(), real.begin(), real.end());
    return end_of_folder == folder.end() && rest != real.end();
}

}  // namespace

SceneFolder::SceneFolder(const fs::path& scene_file)
    : folder_(fs::weakly_canonical(fs::absolute(scene_file).parent_path())) {}

std::optional<fs::path> SceneFolder::find(const std::string& name) const {
    const std::vector<std::string> parts = parts_of(name);
    for (std::size_t first = 0; first < parts.size(); ++first) {
        const auto path = below(folder_, std::span(parts).subspan(first));
        if (path && is_within(folder_, *path)) return path;
    }
    if (parts.empty()) return std::nullopt;
    for (const fs::path& subfolder : subfolders(folder_)) {
        const auto path = entry_of(subfolder, parts.back());
        if (path && is_within(folder_, *path)) return path;
    }
    return std::nullopt;
}

std::optional<std::string> SceneFolder::read(const std::string& name) const {
    const std::optional<fs::path> path = find(name);
    if (!path) return std::nullopt;
    try {
        std::string content = read_file(*path, kMaxCopyBytes);
        allow_time_for(content.size());
        return content;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace aoscore::importer
