#pragma once

#include "reference/integrator/tile_store.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace aoscore {

/// How processes that wait for a truth help the one that traces it. Its groups of tiles are divided into
/// chunks. Who begins a chunk makes a file that only one process can make; a helper puts what it traced into
/// a file of its own under a temporary name, and renames it. So nothing is needed of the file system but
/// these two, which NFS has. The files only save work: one that was left behind, or is damaged, costs the
/// time of its chunk and never a result.
class TracingHelp {
  public:
    /// `stem` is the truth's path without its ending, `groups` how many it has.
    TracingHelp(std::filesystem::path stem, std::size_t groups);

    std::size_t chunks() const { return chunks_; }
    std::size_t chunk_of(std::size_t group) const { return group / groups_a_chunk_; }
    std::vector<std::size_t> groups_of(std::size_t chunk) const;

    /// Whether this process is the one that begins the chunk; true as well where that cannot be told.
    bool claim(std::size_t chunk) const;
    /// Publishes a helper's groups of a chunk. Throws file_error where that fails.
    void publish(std::size_t chunk, const std::vector<GroupState>& groups) const;
    /// What a helper published of the chunk: one state a group; nothing where there is none, or it is
    /// damaged.
    std::optional<std::vector<GroupState>> published(std::size_t chunk) const;
    /// Takes back the claims of processes that ended before their time.
    void forget_claims() const;
    /// Removes all files of this help.
    void remove() const;

  private:
    std::filesystem::path file(std::size_t chunk, const char* ending) const;

    std::filesystem::path stem_;
    std::size_t groups_ = 0, chunks_ = 0, groups_a_chunk_ = 1;
};

/// Whether the file belongs to the help for some truth.
bool is_tracing_help(const std::filesystem::path& file);

}  // namespace aoscore
