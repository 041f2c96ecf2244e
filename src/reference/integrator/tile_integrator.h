#pragma once

#include "reference/integrator/tile.h"
#include "reference/integrator/tile_state.h"
#include "reference/integrator/tile_tracer.h"
#include "reference/sampling/sample_plan.h"
#include "reference/tracer/hit_observer.h"
#include "reference/tracer/open_directions.h"
#include "reference/tracer/open_space.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth.h"

#include <optional>
#include <vector>

namespace aoscore {

/// Finds the surface at the centre of pixel (x, y); false for background.
bool see(const RayTracer& scene, const CameraFrame& frame, int x, int y, SurfaceHit& hit);

/// Looks through the centre of pixel (x, y) and notes in `hits` what is there; false for background.
bool find_surface(const RayTracer& scene, const CameraFrame& frame, int x, int y, PrimaryHits& hits,
                  SurfaceHit& hit);

/// The rays of pixel number `pixel` of the image, which sees `hit`.
RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, std::size_t pixel);

/// What is seen through the pixels of a tile: kept, another visit need not look again.
struct SeenTile {
    bool looked = false;
    std::vector<SurfaceHit> surfaces;
    std::vector<PlaceInTile> places;        ///< of these surfaces
    std::optional<std::vector<char>> open;  ///< one flag a surface, see OpenSpace; empty: nothing was proven
};

/// Traces one tile after another. Tiles depend on nothing but their place, so that any thread may do any of
/// them.
class TileIntegrator {
  public:
    TileIntegrator(const ReachableScene& scene, const CameraFrame& frame,
                   const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                   const PointSets& points, const CauseJudge& judge);

    /// All that the settings ask for, going on from `begun`, what is there of this very tile, queries and
    /// extras, where that gives the same state as tracing all of it; null: nothing is there. What an earlier
    /// visit has seen is in `seen`, or is put there; null: nobody keeps it.
    TileState trace(const Tile& tile, const TileState* begun = nullptr, SeenTile* seen = nullptr);
    /// Of all tiles so far, those for bent normals left out.
    std::uint64_t rays() const { return tracer_.rays(); }

  private:
    /// Looks through the tile's pixels.
    void look(const Tile& tile, SeenTile& seen) const;
    /// What a state has whatever is traced; lists the pixels.
    void take_surfaces(const Tile& tile, TileState& state);
    /// Lists the surfaces that are not proven open.
    void list_traced(SeenTile& seen);
    /// Takes over what was traced earlier.
    void restore(const TileState& begun);
    /// Traces what the plan asks for, until it asks for no more.
    void trace_all();
    /// Traces as many rays again, uniform over the hemisphere. Where fewer of them are kept they are not gone
    /// on from, so that their blocks need no merging.
    void trace_open_directions();
    void store(TileState& state) const;

    const RayTracer& scene_;
    const CameraFrame& frame_;
    const std::vector<TruthQuery>& queries_;
    const TruthSettings& settings_;
    SamplePlan plan_;
    HitObserver observer_;
    TileTracer tracer_;
    const std::vector<TruthQuery> first_query_;
    OpenDirections open_directions_;
    TileTracer open_tracer_;
    OpenSpace open_space_;
    double reach_m_ = 0;
    SeenTile own_seen_;                // where nobody keeps it
    const SeenTile* seen_ = nullptr;   // of the tile that is traced
    std::vector<std::size_t> pixels_;  // of its surfaces, into images
    std::vector<std::size_t> traced_;  // surfaces that get rays
    std::vector<PlaceInTile> traced_places_;
    std::vector<int> samples_;  // of those, traced so far
};

}  // namespace aoscore
