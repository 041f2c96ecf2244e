#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace aoscore {

/// A command that other processes repeat, in whatever folder they are started.
struct PlannedCommand {
    std::vector<std::string> arguments;  ///< as they were typed
    std::filesystem::path folder;        ///< where: relative paths among them begin there
    /// The files that they name, and those that a glTF file among them names, each with the digest of its
    /// bytes.
    std::map<std::string, std::string> files;

    /// Of these arguments, in the working folder. Where one names a folder, all files in it count.
    static PlannedCommand of(std::vector<std::string> arguments);

    /// Reads what json() gave. `where` names its source in errors.
    static PlannedCommand of_json(const nlohmann::json& json, const std::string& where);
    /// {"arguments": [text], "folder": text, "files": {name: digest}}
    nlohmann::json json() const;

    /// Makes its folder the working folder, where its arguments name files; caches and data that environment
    /// variables name stay where they were. Returns the files that have changed since, or are missing. Throws
    /// file_error where the folder is not there.
    std::vector<std::string> enter() const;
};

}  // namespace aoscore
