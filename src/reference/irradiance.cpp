#include "reference/irradiance.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/sampling.h"
#include "core/threads.h"
#include "reference/estimate/falloff.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/tile_integrator.h"
#include "reference/integrator/tile_tracer.h"
#include "reference/tracer/scene_builds.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// Sums what open rays see of the sky.
class SkySeen final : public RayObserver {
  public:
    SkySeen(const Sky& sky, const TruthQuery& query) : sky_(sky), query_(query) {}

    void start(std::size_t sources) override { sums_.assign(sources, 0); }
    void observe(std::size_t source, const ObservedRay& ray) override {
        const double open = 1 - (ray.hit ? occlusion_at(query_, ray.distance_m) : 0);
        if (open > 0) sums_[source] += open * sky_.radiance(glm::dvec3(ray.direction));
    }
    double sum(std::size_t source) const { return sums_[source]; }

  private:
    const Sky& sky_;
    const TruthQuery& query_;
    std::vector<double> sums_;
};

/// Traces the tiles of one picture.
class TileLight {
  public:
    TileLight(const RayTracer& scene, const CameraFrame& frame, const Sky& sky, double radius_m, int samples)
        : scene_(scene),
          frame_(frame),
          sky_(sky),
          queries_{TruthQuery{Falloff::binary, radius_m, 0}},
          samples_(samples),
          points_(PointKind::scrambled_sobol, samples) {}

    /// Fills the tile's pixels by rays of their own for this seed.
    void trace(const Tile& tile, std::uint64_t seed, ImageF& light) const {
        TruthSettings settings;
        settings.seed = seed;
        std::vector<RaySource> sources;
        std::vector<std::size_t> pixels;
        SurfaceHit hit;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                if (!see(scene_, frame_, x, y, hit)) continue;
                pixels.push_back(light.index(x, y));
                sources.push_back(ray_source(hit, settings, pixels.back()));
            }
        }
        if (pixels.empty()) return;
        const std::vector<SampleRange> ranges(pixels.size(), SampleRange{0, samples_});
        SkySeen seen(sky_, queries_.front());
        TileTracer tracer(scene_, queries_, points_, false, &seen);
        tracer.start(std::move(sources));
        tracer.trace(ranges);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            light.pixels[pixels[i]] = static_cast<float>(seen.sum(i) / samples_);
    }

  private:
    const RayTracer& scene_;
    const CameraFrame& frame_;
    const Sky& sky_;
    const std::vector<TruthQuery> queries_;
    int samples_;
    const PointSets points_;
};

}  // namespace

Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Sky& sky, double radius_m,
                            int samples, std::uint64_t seed) {
    if (samples < 2 || samples % 2 != 0)
        throw usage_error(std::to_string(samples) + " rays for two halves", "samples", "2 or more, even");
    SceneBuilds builds(scene, TraceBuild());
    const ReachableScene reachable = builds.reachable(frame, radius_m);
    const TileLight light(reachable.tracer, frame, sky, radius_m, samples / 2);
    Irradiance irradiance;
    irradiance.halves.fill(ImageF(frame.width(), frame.height(), 0));
    const std::vector<Tile> tiles = tiles_of(frame.width(), frame.height());
    parallel_for(tiles.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const FlushDenormals flush;
        for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
            light.trace(tiles[i], mix_bits(seed ^ ((half + 1) << 32)), irradiance.halves[half]);
    });
    return irradiance;
}

}  // namespace aoscore
