#pragma once

#include <filesystem>

namespace aoscore {

/// Collects the files of a run in a hidden folder inside `target` until all of them are there: a run that is
/// stopped leaves `target` as it was. The next run removes files that a killed process left behind.
class StagedFolder {
  public:
    /// Makes `target` where it is missing. Throws file_error when it cannot be written.
    explicit StagedFolder(std::filesystem::path target);
    ~StagedFolder();
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;

    /// The folder to write to.
    const std::filesystem::path& path() const { return staging_; }
    /// Moves every file to its place in `target`, over older files of the same name; other files stay.
    void publish();

  private:
    std::filesystem::path target_, staging_;
    bool made_target_;
};

}  // namespace aoscore
