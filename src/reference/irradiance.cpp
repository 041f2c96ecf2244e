#include "reference/irradiance.h"

#include "core/environment_peaks.h"
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

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace aoscore {
namespace {

/// An environment with its peaks apart.
struct DividedLight {
    const Environment& all;
    const EnvironmentPeaks peaks;
    explicit DividedLight(const Environment& environment) : all(environment), peaks(environment) {}
};

/// Sums what open rays see of the light without its peaks.
class LightSeen final : public RayObserver {
  public:
    LightSeen(const DividedLight& light, const TruthQuery& query) : light_(light), query_(query) {}

    void start(std::size_t sources) override { sums_.assign(sources, glm::dvec3(0)); }
    void observe(std::size_t source, const ObservedRay& ray) override {
        const double open = 1 - (ray.hit ? occlusion_at(query_, ray.distance_m) : 0);
        if (open > 0)
            sums_[source] += open * light_.peaks.rest(light_.all.radiance(glm::dvec3(ray.direction)));
    }
    const glm::dvec3& sum(std::size_t source) const { return sums_[source]; }

  private:
    const DividedLight& light_;
    const TruthQuery& query_;
    std::vector<glm::dvec3> sums_;
};

/// Traces the tiles of one picture.
class TileLight {
  public:
    TileLight(const RayTracer& scene, const CameraFrame& frame, const DividedLight& light, double radius_m,
              int samples)
        : scene_(scene),
          frame_(frame),
          light_(light),
          queries_{TruthQuery{Falloff::binary, radius_m, 0}},
          samples_(samples),
          points_(PointKind::scrambled_sobol, samples) {}

    /// Fills the tile's pixels by rays of their own for this seed.
    void trace(const Tile& tile, std::uint64_t seed, Image<glm::vec3>& lit) const {
        TruthSettings settings;
        settings.seed = seed;
        std::vector<RaySource> sources;
        std::vector<std::size_t> pixels;
        SurfaceHit hit;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                if (!see(scene_, frame_, x, y, hit)) continue;
                pixels.push_back(lit.index(x, y));
                sources.push_back(ray_source(hit, settings, pixels.back()));
            }
        }
        if (pixels.empty()) return;
        const std::vector<SampleRange> ranges(pixels.size(), SampleRange{0, samples_});
        LightSeen seen(light_, queries_.front());
        TileTracer tracer(scene_, queries_, points_, false, &seen);
        tracer.start(sources);
        tracer.trace(ranges);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            lit.pixels[pixels[i]] =
                glm::vec3((seen.sum(i) + peaks_at(sources[i])) / static_cast<double>(samples_));
    }

  private:
    /// The sum over rays to the peaks of what each brings, over pi.
    glm::dvec3 peaks_at(const RaySource& source) const {
        glm::dvec3 sum(0);
        if (light_.peaks.empty()) return sum;
        const std::uint64_t bits = mix_bits(source.seed ^ 0x70656b73);  // not those of the other rays
        const PointSets::Coordinates points = points_.set(bits);
        const auto shift_u = static_cast<std::uint32_t>(bits >> 32),
                   shift_v = static_cast<std::uint32_t>(bits);
        for (int i = 0; i < samples_; ++i) {
            const EnvironmentPeaks::Sample sample = light_.peaks.sample(
                double{unit_interval(points.u[i] ^ shift_u)}, double{unit_interval(points.v[i] ^ shift_v)});
            const double cosine = glm::dot(glm::dvec3(source.frame[2]), sample.from);
            if (cosine <= 0) continue;
            const TraceRay ray{source.origin, glm::vec3(sample.from), 0,
                               static_cast<float>(queries_.front().radius_m)};
            if (!scene_.occluded(ray)) sum += cosine / std::numbers::pi * sample.radiance_by_chance;
        }
        return sum;
    }

    const RayTracer& scene_;
    const CameraFrame& frame_;
    const DividedLight& light_;
    const std::vector<TruthQuery> queries_;
    int samples_;
    const PointSets points_;
};

Irradiance traced(const RayTracer& scene, const CameraFrame& frame, const DividedLight& divided,
                  double radius_m, int samples, std::uint64_t seed) {
    const TileLight light(scene, frame, divided, radius_m, samples / 2);
    Irradiance irradiance;
    irradiance.samples = samples;
    irradiance.halves.fill(Image<glm::vec3>(frame.width(), frame.height(), glm::vec3(0)));
    const std::vector<Tile> tiles = tiles_of(frame.width(), frame.height());
    parallel_for(tiles.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const FlushDenormals flush;
        for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
            light.trace(tiles[i], mix_bits(seed ^ ((half + 1) << 32)), irradiance.halves[half]);
    });
    return irradiance;
}

/// Pixels that any light reaches: without surface there is none.
Mask lit_pixels(const Irradiance& irradiance) {
    Mask lit(irradiance.halves[0].width, irradiance.halves[0].height, 0);
    for (std::size_t i = 0; i < lit.size(); ++i) lit.pixels[i] = luminance(irradiance.mean(i)) > 0 ? 1 : 0;
    return lit;
}

template <class Value>
double mean_over(const Mask& counted, const Value& value) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        if (counted.pixels[i] == 0) continue;
        sum += value(i);
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

double standard_error(const Irradiance& irradiance, const Mask& counted) {
    return std::sqrt(mean_over(counted, [&](std::size_t i) {
        const glm::dvec3 apart(irradiance.halves[0].pixels[i] - irradiance.halves[1].pixels[i]);
        return std::pow(luminance(apart) / 2, 2);
    }));
}

double mean_luminance(const Irradiance& irradiance, const Mask& counted) {
    return mean_over(counted, [&](std::size_t i) { return luminance(irradiance.mean(i)); });
}

Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Environment& environment,
                            double radius_m, int samples, std::uint64_t seed) {
    return trace_irradiance(scene, frame, environment, radius_m, IrradianceGoal{0, samples, samples}, seed);
}

Irradiance trace_irradiance(const Scene& scene, const CameraFrame& frame, const Environment& environment,
                            double radius_m, const IrradianceGoal& goal, std::uint64_t seed) {
    if (goal.first < 2 || goal.first % 2 != 0)
        throw usage_error(std::to_string(goal.first) + " rays for two halves", "samples", "2 or more, even");
    SceneBuilds builds(scene, TraceBuild());
    const ReachableScene reachable = builds.reachable(frame, radius_m);
    const DividedLight light(environment);
    for (int samples = goal.first;;) {
        Irradiance irradiance = traced(reachable.tracer, frame, light, radius_m, samples, seed);
        const Mask lit = lit_pixels(irradiance);
        const double allowed = goal.relative_error * mean_luminance(irradiance, lit);
        const double error = standard_error(irradiance, lit);
        if (samples * 2 > goal.most || error <= allowed) return irradiance;
        // Errors of scrambled Sobol points fall faster than those of independent rays, here taken as with the
        // power 3/4 of the number; each step traces all of them anew.
        const double needed = samples * std::pow(error / allowed, 4.0 / 3);
        do samples *= 2;
        while (samples < needed && samples * 2 <= goal.most);
    }
}

}  // namespace aoscore
