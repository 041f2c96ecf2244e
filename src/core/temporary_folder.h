#pragma once

#include <filesystem>

namespace aoscore {

/// A new folder among the system's temporary files, which nobody else may enter; removed with all that is in
/// it when this object ends.
class TemporaryFolder {
  public:
    /// Throws file_error when it cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace aoscore
