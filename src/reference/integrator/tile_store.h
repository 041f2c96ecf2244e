#pragma once

#include "reference/integrator/tile_state.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// The tiles of one group, see TileGroups.
struct GroupState {
    std::vector<TileState> tiles;
    double seconds = 0;  ///< one thread's time for them
};

/// Where the tiles of a truth are kept between runs. All members may be called from any thread.
class TileStore {
  public:
    TileStore() = default;
    TileStore(const TileStore&) = delete;
    TileStore& operator=(const TileStore&) = delete;
    virtual ~TileStore() = default;

    /// Whether this group is there, as far as it was asked for.
    virtual bool has(std::size_t group) const = 0;
    /// Whether another process has begun this group, so that it comes last: it may be there by then.
    virtual bool begun_elsewhere(std::size_t) { return false; }
    /// That group.
    virtual GroupState load(std::size_t group) const = 0;
    /// Tiles of this group with fewer rays, of the same queries and extras; none where there are none.
    virtual GroupState begun(std::size_t group) const = 0;
    /// Keeps a group that is done.
    virtual void keep(std::size_t group, const GroupState& state) = 0;
    /// Where the search for the rays of TruthSettings::mean_error keeps what it traces, by numbers of its
    /// own; null where nowhere.
    virtual TileStore* of_search() { return nullptr; }
};

}  // namespace aoscore
