#pragma once

#include "reference/truth.h"
#include "scene/scene.h"
#include "store/truth/truth_request.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {

/// The origin of a truth.
enum class TruthOrigin : std::uint8_t {
    traced,   ///< all rays were traced now
    resumed,  ///< tracing went on where an interrupted run stopped
    refined,  ///< tracing went on from a truth with fewer rays
    cached,   ///< no ray was traced
    given,    ///< another program's, read from a file
};
std::string_view origin_id(TruthOrigin origin);

/// Names a truth's scene and view for people; no key depends on it.
struct TruthLabel {
    std::string scene;    ///< as scene_name() names it
    std::string view;     ///< its id
    std::string command;  ///< the command that asked for it
};

/// The name by which load_scene() finds this scene from any folder: a built-in's id, or a file's absolute
/// path.
std::string scene_name(const Scene& scene);

struct CachedTruth {
    Truth truth;
    TruthOrigin origin = TruthOrigin::traced;
    TruthRequest made_for;  ///< the request that it was traced for: as asked, or more
};

/// One file of a cache.
struct CacheEntry {
    std::filesystem::path file;
    std::uint64_t bytes = 0;
    double age_s = 0;       ///< time since the last write
    bool readable = false;  ///< whether its header could be read; if not, all below is empty
    bool complete = false;  ///< all groups of tiles are there
    std::uint64_t damaged_bytes = 0;
    bool current = false;  ///< traced by this version of the integrator and of Embree
    TruthLabel label;
    TruthRequest request;
    std::size_t groups_done = 0, groups = 0;
};

/// The result of tracing tiles of a CacheEntry again.
struct CacheVerdict {
    std::size_t groups_compared = 0;
    std::size_t groups_differing = 0;
    std::string not_traced;  ///< why no tiles were compared; empty when some were
};

struct ClearedCache {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
    std::size_t kept_in_use = 0;  ///< files kept because another process is using them
};

/// Keeps truths in a folder, so that none is traced twice. Every file is named by the digest of all that its
/// bits depend on, so that no stale one is ever served. Tiles are stored as they are done: a run that was
/// killed goes on where it stopped. Any number of processes may use one folder: one that wants a truth that
/// another is tracing traces some of its tiles, and waits for the others. The damaged groups of a file are
/// traced again, with a warning. Where the folder cannot be written, truths are traced all the same, with a
/// warning.
class TruthCache {
  public:
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Returns the truth of ReferenceScene::trace() for the same scene, queries and settings, or a better one
    /// (see serves()).
    CachedTruth trace(const ReferenceScene& reference, const TruthRequest& request, const TruthLabel& label,
                      const std::string& what) const;

    /// Lists all files, by name.
    std::vector<CacheEntry> list() const;
    /// Loads the scene of an entry and traces `groups` groups of its tiles again, evenly spread, comparing
    /// them bit by bit.
    static CacheVerdict verify(const CacheEntry& entry, std::size_t groups);
    /// Removes all files but those that a process is using.
    ClearedCache clear() const;

  private:
    std::filesystem::path folder_;
};

/// Does TruthCache::trace() with the cache in `folder`, or traces without a cache where that is empty. With
/// TruthSettings::halves it gives the two halves, each a truth of its own for the cache, and their mean.
CachedTruth trace_truth(const std::filesystem::path& folder, const ReferenceScene& reference,
                        const TruthRequest& request, const TruthLabel& label, const std::string& what);

/// Removes from the cache in `folder` the truth that trace_truth() has stored for exactly this request.
void forget_truth(const std::filesystem::path& folder, const TruthRequest& request);

}  // namespace aoscore
