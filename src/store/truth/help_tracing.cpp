#include "store/truth/help_tracing.h"

#include "core/error.h"
#include "store/truth/cache_file.h"
#include "store/truth/tile_codec.h"

#include <map>
#include <mutex>
#include <utility>

namespace aoscore {
namespace {

/// Gathers the groups of the chunk that is being traced.
class ChunkStore final : public TileStore {
  public:
    explicit ChunkStore(const CacheFile* base) : base_(base) {}

    bool has(std::size_t) const override { return false; }
    GroupState load(std::size_t) const override { throw internal_error("a chunk holds nothing to load"); }
    GroupState begun(std::size_t group) const override {
        return base_ != nullptr && base_->has(group) ? decode(base_->read(group), "a truth of fewer rays")
                                                     : GroupState{};
    }
    void keep(std::size_t group, const GroupState& state) override {
        const std::scoped_lock lock(mutex_);
        traced_[group] = state;
    }
    /// What was kept since this was last asked for, by number of the group.
    std::vector<GroupState> taken() {
        std::vector<GroupState> states;
        for (auto& [group, state] : std::exchange(traced_, {})) states.push_back(std::move(state));
        return states;
    }

  private:
    const CacheFile* base_;
    std::mutex mutex_;
    std::map<std::size_t, GroupState> traced_;
};

}  // namespace

void help_tracing(const TracingHelp& help, const ReferenceScene& reference, const TruthRequest& request,
                  const CacheFile* base, const std::function<bool()>& ended) {
    ChunkStore store(base);
    std::size_t chunk = help.chunks();
    const auto next = [&]() -> std::vector<std::size_t> {
        if (const std::vector<GroupState> states = store.taken(); !states.empty())
            help.publish(chunk, states);
        if (ended()) return {};
        while (chunk > 0) {
            if (help.claim(--chunk)) return help.groups_of(chunk);
        }
        return {};
    };
    reference.trace_into(store, CameraFrame(request.camera, request.width, request.height), request.queries,
                         request.settings, next);
}

}  // namespace aoscore
