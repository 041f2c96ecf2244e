#include "reference/benchmark/plain_monte_carlo.h"

#include "core/sampling.h"
#include "core/threads.h"
#include "reference/benchmark/processor_time.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/tile_integrator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace aoscore {
namespace {

/// The open part of `samples` independent rays.
double open_part(const EmbreeScene& scene, const RaySource& source, float radius_m, int samples) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    int blocked = 0;
    for (int i = 0; i < samples; ++i) {
        const std::uint64_t bits = mix_bits(source.seed + static_cast<std::uint64_t>(i));
        const glm::vec3 d =
            source.frame * cosine_hemisphere(unit_interval(static_cast<std::uint32_t>(bits)),
                                             unit_interval(static_cast<std::uint32_t>(bits >> 32)));
        RTCRay ray{
            source.origin.x, source.origin.y, source.origin.z, 0, d.x, d.y, d.z, 0, radius_m, ~0u, 0, 0};
        rtcOccluded1(scene.handle(), &context, &ray);
        blocked += ray.tfar < 0;
    }
    return 1 - static_cast<double>(blocked) / samples;
}

}  // namespace

double plain_rate(const EmbreeScene& scene, const CameraFrame& frame, double radius_m, int samples,
                  std::span<const Tile> tiles) {
    constexpr int kRuns = 3;
    double best = 0;
    for (int run = 0; run < kRuns; ++run) {
        std::atomic<std::uint64_t> rays{0};
        std::atomic<double> open{0};  // used, so that no ray is left out
        const double seconds = seconds_of([&] {
            parallel_for(tiles.size(), [&](std::size_t t) {
                const FlushDenormals flush;
                for (int y = tiles[t].y0; y < tiles[t].y1; ++y) {
                    for (int x = tiles[t].x0; x < tiles[t].x1; ++x) {
                        SurfaceHit hit;
                        if (!see(scene, frame, x, y, hit)) continue;
                        const std::size_t pixel =
                            static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width()) +
                            static_cast<std::size_t>(x);
                        open += open_part(scene, ray_source(hit, {}, pixel), static_cast<float>(radius_m),
                                          samples);
                        rays += static_cast<std::uint64_t>(samples);
                    }
                }
            });
        });
        if (open > 0 || rays > 0) best = std::max(best, static_cast<double>(rays) / seconds / 1e6);
    }
    return best;
}

PlainMonteCarlo::PlainMonteCarlo(const Truth& truth) {
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        const double v = truth.visibility[0].pixels[i];
        if (truth.hits.surface.pixels[i] != 0) deviations_.push_back(std::sqrt(v * (1 - v)));
    }
}

double PlainMonteCarlo::samples_for(double error) const {
    const double sum = std::accumulate(deviations_.begin(), deviations_.end(), 0.0);
    return std::pow(sum / static_cast<double>(deviations_.size()) / error, 2);
}

double PlainMonteCarlo::best_samples_for(double error) const {
    double sum = 0;
    for (const double d : deviations_) sum += std::cbrt(d * d);
    return std::pow(sum / static_cast<double>(deviations_.size()), 3) / (error * error);
}

}  // namespace aoscore
