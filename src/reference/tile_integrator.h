#pragma once

#include "reference/embree_scene.h"
#include "reference/estimate.h"
#include "reference/hit_observer.h"
#include "reference/open_space.h"
#include "reference/sample_plan.h"
#include "reference/tile.h"
#include "reference/tile_tracer.h"
#include "reference/truth.h"

#include <vector>

namespace aoscore {

/// Looks through the centre of pixel (x, y) and notes in `hits` what is there; false for background.
bool find_surface(const EmbreeScene& scene, const CameraFrame& frame, int x, int y, PrimaryHits& hits,
                  SurfaceHit& hit);

/// The rays of pixel number `pixel` of the image, which sees `hit`.
RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, std::size_t pixel);

/// Cone angle of a bent normal, see Truth::cone_angle_rad.
double cone_angle_rad(const glm::dvec3& bent_normal);

/// Makes the truth of one tile after another. Tiles depend on nothing but their place, so that any thread may
/// do any of them.
class TileIntegrator {
  public:
    TileIntegrator(const EmbreeScene& scene, const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                   const TruthSettings& settings, const PointSets& points, const CauseJudge& judge);

    /// Fills the tile's pixels of all images of `truth`.
    void integrate(const Tile& tile, Truth& truth);
    /// Of all tiles so far.
    std::uint64_t rays() const { return tracer_.rays(); }
    std::uint64_t open_pixels() const { return open_pixels_; }

  private:
    /// Where the tile's surfaces lie; also into truth.hits.
    void find_surfaces(const Tile& tile, PrimaryHits& hits);
    /// Takes the pixels that are proven open out of the list and stores them.
    void skip_open(Truth& truth);
    /// Estimates of all pixels for one query.
    std::vector<Estimate> estimates(std::size_t query) const;
    /// Traces what the plan asks for, until it asks for no more.
    void trace_all();
    void store(Truth& truth) const;
    void store_extras(std::size_t surface, Truth& truth) const;

    const EmbreeScene& scene_;
    const CameraFrame& frame_;
    const std::vector<TruthQuery>& queries_;
    const TruthSettings& settings_;
    SamplePlan plan_;
    HitObserver observer_;
    TileTracer tracer_;
    OpenSpace open_space_;
    double reach_m_ = 0;
    std::uint64_t open_pixels_ = 0;
    std::vector<SurfaceHit> surfaces_;
    std::vector<std::size_t> pixels_;  // of surfaces, into images
    std::vector<int> samples_;         // of surfaces, traced so far
};

}  // namespace aoscore
