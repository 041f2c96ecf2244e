#pragma once

#include "reference/integrator/tile.h"
#include "reference/integrator/tile_state.h"
#include "reference/sampling/pilot.h"
#include "reference/tracer/hit_observer.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace aoscore {

/// Traces some tiles of a picture to find the rays that TruthSettings::mean_error takes, and keeps what it
/// traced, so that the picture goes on from there.
class MeanErrorPilot {
  public:
    MeanErrorPilot(const ReachableScene& scene, const CameraFrame& frame,
                   const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                   const CauseJudge& judge, const TellRays& tell);

    /// For every pixel, and the time that they take together.
    const EvenRays& rays() const { return rays_; }
    /// What is there of a tile; null where nothing is.
    const TileState* state_of(const Tile& tile) const;
    /// Whether that is all that the picture has there.
    bool is_done(const TileState& state) const;

  private:
    std::vector<TileErrors> trace_first(std::size_t tiles, int samples);
    TileErrors errors_of(const Tile& tile, const TileState& state) const;

    const ReachableScene& scene_;
    const CameraFrame& frame_;
    const std::vector<TruthQuery>& queries_;
    const CauseJudge& judge_;
    TruthSettings settings_;  // of even rays, without extras
    bool usable_;             // whether the picture can go on from what is traced here
    std::vector<Tile> tiles_;
    std::vector<TileState> states_;  // of the first of these tiles
    EvenRays rays_;
    std::map<std::pair<int, int>, std::size_t> numbers_;  // of those with a state, by first row and column
};

}  // namespace aoscore
