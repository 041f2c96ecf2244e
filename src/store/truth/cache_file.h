#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A file of blocks, each with a digest of its own: the first says what the file is, then come groups of
/// tiles in any order, and the last says that all are there. The file only grows, so that a process that is
/// killed loses no more than the block that it was writing. Opening checks every digest.
class CacheFile {
  public:
    enum class Mode { read, append };
    /// Opens an existing file. Throws file_error when there is no such file, or no header in it.
    CacheFile(const std::filesystem::path& path, Mode mode);
    /// Begins a new file, over any older one.
    CacheFile(const std::filesystem::path& path, const nlohmann::json& header);
    ~CacheFile();
    CacheFile(const CacheFile&) = delete;
    CacheFile& operator=(const CacheFile&) = delete;

    const nlohmann::json& header() const { return header_; }
    bool has(std::size_t group) const;
    /// Reads the bytes of a group that is there. Any thread may call it.
    std::string read(std::size_t group) const;
    std::size_t groups() const;
    /// The numbers of the groups that are there.
    std::vector<std::size_t> numbers() const;
    /// Whether the block that ends a complete file is there.
    bool finished() const { return finished_; }
    /// Bytes that could not be understood when the file was opened.
    std::uint64_t damaged_bytes() const { return damaged_bytes_; }

    /// Appends a group. Any thread may call it. Throws file_error when the file cannot be written.
    void append(std::size_t group, std::string_view bytes);
    /// Marks the file as complete, and flushes it to the disk.
    void finish();

  private:
    struct Place {
        std::uint64_t offset, size;
    };
    enum class Kind : std::uint32_t { header = 1, group = 2, end = 3 };
    void scan();
    void write_block(Kind kind, std::uint32_t index, std::string_view bytes);

    std::filesystem::path path_;
    int descriptor_ = -1;
    nlohmann::json header_;
    mutable std::mutex mutex_;
    std::map<std::size_t, Place> groups_;
    std::uint64_t end_ = 0;  ///< end of the valid bytes
    std::uint64_t damaged_bytes_ = 0;
    bool finished_ = false;
};

}  // namespace aoscore
