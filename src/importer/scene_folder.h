#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace aoscore::importer {

/// The folder of a scene's file, with the files that it names: none outside it is ever opened.
class SceneFolder {
  public:
    explicit SceneFolder(const std::filesystem::path& scene_file);

    const std::filesystem::path& path() const { return folder_; }

    /// Finds the regular file that a scene names, whose name may have backslashes, other letter case or a
    /// path of its author's machine. It tries the whole path below the folder, then the last parts of the
    /// path, then the file's name in each folder in this one. Returns nothing where there is none.
    std::optional<std::filesystem::path> find(const std::string& name) const;

    /// Reads such a file; returns nothing where there is none, or it cannot be read.
    std::optional<std::string> read(const std::string& name) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace aoscore::importer
