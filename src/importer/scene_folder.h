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

    /// The regular file that a scene names in whatever way its author's machine did: with backslashes, in
    /// other letter case, by a path of that machine. Tried are the whole path below the folder, then its last
    /// parts, then its name in each of the folder's own folders. Nothing where there is none.
    std::optional<std::filesystem::path> find(const std::string& name) const;

    /// The content of such a file; nothing where there is none, or it cannot be read.
    std::optional<std::string> read(const std::string& name) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace aoscore::importer
