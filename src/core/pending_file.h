#pragma once

#include <filesystem>
#include <memory>

namespace aoscore {

class TemporaryFolder;

/// A file that is being made: its writer writes to temporary(), and publish() brings that to its place at
/// once. A reader sees the old file, the new one, or none, never half of one. A symbolic link is followed,
/// and what is no regular file (a device, a pipe) is written through and stays what it is. Without publish()
/// nothing is left.
class PendingFile {
  public:
    /// Folders above `path` are not made. Throws file_error for a folder, a circle of links, and a device
    /// that may not be written.
    explicit PendingFile(const std::filesystem::path& path);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    /// A file with the path's extension, in its folder; for a device in the folder of temporary files.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Call it once, when the temporary file is whole. Throws file_error, and interrupted_error where Ctrl-C
    /// is pressed while a pipe has no reader.
    void publish();

  private:
    std::filesystem::path path_;                  ///< as it was given, for messages
    std::filesystem::path target_;                ///< the path behind symbolic links
    std::unique_ptr<TemporaryFolder> elsewhere_;  ///< set where the target exists and is no regular file
    std::filesystem::path temporary_;
};

/// Moves a whole file to its place, as PendingFile::publish() does; also from one file system to another.
void move_to_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace aoscore
