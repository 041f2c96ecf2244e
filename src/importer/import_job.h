#pragma once

#include "importer/scene_folder.h"
#include "scene/import/plain_scene.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

namespace aoscore::importer {

/// One file to be read, and the scene that was made of it so far.
struct ImportJob {
    std::filesystem::path file;
    SceneFolder folder;
    bool albedo = false;  ///< whether images that only give colour are wanted too
    imported::PlainScene plain;

    /// Adds a warning unless it is there already.
    void warn(std::string text) {
        auto& warnings = plain.scene.warnings;
        if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
            warnings.push_back(std::move(text));
    }
};

}  // namespace aoscore::importer
