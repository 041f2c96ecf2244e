#pragma once

#include "reference/integrator/tile.h"
#include "reference/integrator/tile_integrator.h"
#include "reference/integrator/tile_state.h"
#include "reference/integrator/tile_store.h"
#include "reference/sampling/pilot.h"
#include "reference/tracer/hit_observer.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// Traces some tiles of a picture to find the rays that TruthSettings::mean_error takes, and keeps what it
/// traced, so that the picture goes on from there.
class MeanErrorPilot {
  public:
    /// Searches at once. `store`, which may be null, is the store of a search: what an interrupted one has
    /// traced is taken from there. `what` names the work for the progress of the search; empty: it shows
    /// none.
    MeanErrorPilot(const ReachableScene& scene, const CameraFrame& frame,
                   const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                   const CauseJudge& judge, TileStore* store, const std::string& what, const TellRays& tell);

    /// For every pixel, and the time that they take together.
    const EvenRays& rays() const { return rays_; }
    /// What is there of a tile.
    struct Begun {
        const TileState* state = nullptr;  ///< null: nothing
        SeenTile* seen = nullptr;          ///< for the visit of the picture; null: not kept
        bool done = false;                 ///< that is all that the picture has there
    };
    Begun begun(const Tile& tile);
    /// That it traced; none of what was there.
    std::uint64_t traced_rays() const { return traced_rays_; }

  private:
    PilotMeasure trace_first(std::size_t tiles, int samples);
    TileErrors errors_of(const SpreadTile& tile, const TileState& state) const;

    const ReachableScene& scene_;
    const CameraFrame& frame_;
    const std::vector<TruthQuery>& queries_;
    const CauseJudge& judge_;
    TruthSettings settings_;  // of even rays, without extras
    bool usable_;             // whether the picture can go on from what is traced here
    TileStore* store_;
    std::string what_;
    std::size_t measures_ = 0;  // so far
    std::atomic<std::uint64_t> traced_rays_{0};
    std::vector<SpreadTile> tiles_;
    std::vector<TileState> states_;  // of the first of these tiles
    std::vector<int> samples_;       // that they were traced with
    std::vector<SeenTile> seen_;     // through them
    EvenRays rays_;
    std::map<std::pair<int, int>, std::size_t> numbers_;  // of those with a state, by first row and column
};

}  // namespace aoscore
