#include "jobs/planned_command.h"

#include "core/error.h"
#include "core/folders.h"
#include "core/hash.h"
#include "core/strict_json.h"
#include "scene/gltf/side_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// Options whose value is a file that the command writes, or that no job depends on.
constexpr std::array<std::string_view, 3> kNoInputs = {"--out", "--export", "--baseline"};

bool is_no_input(std::string_view option) {
    return std::ranges::find(kNoInputs, option) != kNoInputs.end();
}

/// The digest of a file's bytes; of none where it cannot be read.
std::string digest_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    Digest digest;
    std::array<char, std::size_t{1} << 16> buffer;
    while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0)
        digest.bytes(buffer.data(), static_cast<std::size_t>(in.gcount()));
    return digest.hex();
}

/// The paths that a word may be: itself, or the value of an option; several between commas.
std::vector<std::string> possible_paths(const std::string& word) {
    std::string value = word;
    if (word.starts_with("--")) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || is_no_input(word.substr(0, equals))) return {};
        value = word.substr(equals + 1);
    }
    std::vector<std::string> paths{value};
    std::istringstream list(value);
    for (std::string part; std::getline(list, part, ',');) paths.push_back(part);
    return paths;
}

/// Adds a file, and those that it names in turn.
void add_file(const fs::path& file, std::map<std::string, std::string>& files) {
    files[file.string()] = digest_of(file);
    for (const fs::path& side : gltf::side_files(file)) files[side.string()] = digest_of(side);
}

void add_files(const fs::path& named, std::map<std::string, std::string>& files) {
    std::error_code ec;
    if (fs::is_regular_file(named, ec)) add_file(named, files);
    if (!fs::is_directory(named, ec)) return;
    for (const auto& entry : fs::recursive_directory_iterator(named, ec)) {
        if (entry.is_regular_file(ec)) add_file(entry.path(), files);
    }
}

}  // namespace

PlannedCommand PlannedCommand::of(std::vector<std::string> arguments) {
    PlannedCommand command{std::move(arguments), fs::current_path(), {}};
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
        if (i > 0 && is_no_input(command.arguments[i - 1])) continue;
        for (const std::string& path : possible_paths(command.arguments[i])) add_files(path, command.files);
    }
    return command;
}

PlannedCommand PlannedCommand::of_json(const nlohmann::json& json, const std::string& where) {
    StrictObject object(json, where);
    PlannedCommand command{object.texts_or_empty("arguments"), object.text("folder"), {}};
    for (const auto& [file, digest] : object.object("files").members()) {
        if (!digest.is_string()) throw file_error("is no digest", object.where("files"), "a text");
        command.files[file] = digest.get<std::string>();
    }
    object.finish();
    return command;
}

nlohmann::json PlannedCommand::json() const {
    return {{"arguments", arguments}, {"folder", folder.string()}, {"files", files}};
}

std::vector<std::string> PlannedCommand::enter() const {
    if (files.empty()) return {};
    std::error_code ec;
    if (!fs::is_directory(folder, ec))
        throw file_error("is not there, and the planned command names files from it", folder.string(),
                         "a machine that sees the same folders");
    work_in(folder);
    std::vector<std::string> changed;
    for (const auto& [file, digest] : files) {
        if (!fs::exists(file, ec) || digest_of(file) != digest) changed.push_back(file);
    }
    return changed;
}

}  // namespace aoscore
