#pragma once

#include <filesystem>
#include <functional>
#include <optional>

namespace aoscore {

/// Holds a lock file, so that only one process works on a cache file. The system releases it when the process
/// ends, however it ends. The file is removed with the lock. Where the file system has no locks, everybody has it.
class EntryLock {
  public:
    /// Waits for the lock; calls `waiting` once when it is not free at once. Throws file_error when the file
    /// cannot be made, interrupted_error on Ctrl-C.
    static EntryLock acquire(const std::filesystem::path& path, const std::function<void()>& waiting);
    /// Nothing when another process has it.
    static std::optional<EntryLock> try_acquire(const std::filesystem::path& path);

    EntryLock(EntryLock&& other) noexcept;
    EntryLock& operator=(EntryLock&&) = delete;
    ~EntryLock();

  private:
    EntryLock(std::filesystem::path path, int descriptor);
    std::filesystem::path path_;
    int descriptor_;
};

}  // namespace aoscore
