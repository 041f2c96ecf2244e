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

/// How a truth was come by.
enum class TruthOrigin : std::uint8_t {
    traced,   ///< every ray of it, now
    resumed,  ///< what an interrupted run left was taken over
    refined,  ///< a truth with fewer rays was gone on from
    cached,   ///< no ray was traced
};
std::string_view origin_id(TruthOrigin origin);

/// What a truth is of, for people: no key depends on it.
struct TruthLabel {
    std::string scene;    ///< as load_scene() takes it; files by their absolute path
    std::string view;     ///< id
    std::string command;  ///< that asked for it
};

/// How load_scene() finds this scene again from anywhere: a built-in's id, or a file's absolute path.
std::string scene_name(const Scene& scene);

struct CachedTruth {
    Truth truth;
    TruthOrigin origin = TruthOrigin::traced;
    TruthRequest made_for;  ///< what it was traced for: what was asked for, or more
};

/// One file of a cache.
struct CacheEntry {
    std::filesystem::path file;
    std::uint64_t bytes = 0;
    double age_s = 0;       ///< since it was last written to
    bool readable = false;  ///< whether its header could be read; else all below is empty
    bool complete = false;  ///< all groups of tiles are there
    std::uint64_t damaged_bytes = 0;
    bool current = false;  ///< traced by this version of the integrator and of Embree
    TruthLabel label;
    TruthRequest request;
    std::size_t groups_done = 0, groups = 0;
};

/// What CacheEntry's tiles are worth, traced again.
struct CacheVerdict {
    std::size_t groups_compared = 0;
    std::size_t groups_differing = 0;
    std::string not_traced;  ///< why none were compared; empty when some were
};

struct ClearedCache {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
    std::size_t kept_in_use = 0;  ///< files that another process is working on
};

/// The folder of the user's cache: the environment variable AOSCORE_CACHE where it is set, else
/// references/cache below home_dir().
std::filesystem::path default_cache_dir();

/// Truths kept in a folder, so that none is traced twice. Every file is named by the digest of all that its
/// bits depend on, so that nothing stale is ever served. Tiles are put away as they are done: a run that is
/// killed goes on where it was. Any number of processes may use one folder: who wants what another one is
/// tracing waits for it. A damaged file is said so, thrown away as far as it is damaged, and traced anew.
/// Where the folder cannot be written, truths are traced all the same, with a warning.
class TruthCache {
  public:
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// As ReferenceScene::trace() of the same scene, queries and settings; or better, see serves().
    CachedTruth trace(const ReferenceScene& reference, const TruthRequest& request, const TruthLabel& label,
                      const std::string& what) const;

    /// All files, by name.
    std::vector<CacheEntry> list() const;
    /// Loads the scene of an entry and traces `groups` groups of its tiles again, evenly spread, comparing
    /// them bit by bit.
    static CacheVerdict verify(const CacheEntry& entry, std::size_t groups);
    /// Removes all files but those that a process is writing.
    ClearedCache clear() const;

  private:
    std::filesystem::path folder_;
};

/// TruthCache::trace() of the cache in `folder`; without a cache where that is empty. With
/// TruthSettings::halves its two halves, each a truth of its own for the cache, and their mean.
CachedTruth trace_truth(const std::filesystem::path& folder, const ReferenceScene& reference,
                        const TruthRequest& request, const TruthLabel& label, const std::string& what);

/// Removes from the cache in `folder` what trace_truth() has kept for this very request.
void forget_truth(const std::filesystem::path& folder, const TruthRequest& request);

}  // namespace aoscore
