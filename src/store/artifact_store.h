#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// Keeps measurements under the digest of everything that decides them. Entries are written whole or not at
/// all, so that several processes may share a store; one that is damaged is named in a warning and counts as
/// missing. Where the folder cannot be written, one warning says so, and nothing is kept. The store does not
/// know what its entries mean.
class ArtifactStore {
  public:
    /// The folder for measurements within a cache's folder; empty for an empty path.
    static std::filesystem::path folder_in(const std::filesystem::path& cache);

    /// An empty folder stores and finds nothing.
    explicit ArtifactStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    bool enabled() const { return !folder_.empty(); }
    const std::filesystem::path& folder() const { return folder_; }
    /// Throws file_error where nothing can be written into the folder.
    void require_writable() const;
    /// Whether something that was put could not be written, as the warning has said.
    bool lost_some() const { return warned_; }

    std::optional<nlohmann::json> find(const std::string& key) const;
    void put(const std::string& key, const nlohmann::json& payload) const;

    /// Whether the store has an entry for the key, which may be damaged.
    bool has(const std::string& key) const;

    /// The file that was put under the key, whole; empty where there is none, or it is damaged.
    std::optional<std::filesystem::path> file(const std::string& key) const;
    /// Copies that file to `target`; false where there is none, or it is damaged.
    bool fetch_file(const std::string& key, const std::filesystem::path& target) const;
    void put_file(const std::string& key, const std::filesystem::path& source) const;
    /// Says that files put or fetched below `staged` now lie below `published`. The store drops its copies of
    /// them, and remembers their paths. It forgets a file whose place another one has taken. A published file
    /// that is changed or removed counts as missing.
    void settle(const std::filesystem::path& staged, const std::filesystem::path& published) const;

    struct Size {
        std::size_t entries = 0;
        std::uintmax_t bytes = 0;
    };
    Size size() const;
    /// Removes everything; another process that needs an entry makes it again.
    Size clear() const;

    /// The files of all damaged entries.
    std::vector<std::filesystem::path> damaged() const;

  private:
    std::filesystem::path entry(const std::string& key, const std::string& extension) const;
    void keep(const std::filesystem::path& file, const std::string& bytes) const;

    std::filesystem::path folder_;
    mutable bool warned_ = false;
    mutable std::vector<std::pair<std::string, std::filesystem::path>> placed_;  ///< by key, for settle()
};

}  // namespace aoscore
