#include "reference/tile_integrator.h"

#include "core/sampling.h"

#include <algorithm>

namespace aoscore {
namespace {

/// To stop where an error is estimated to be small prefers pixels whose estimate came out too small: by this
/// much, as tests over many seeds show.
constexpr double kStoppingAllowance = 1.06;

RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, int x, int y) {
    const glm::dvec3& axis = settings.shading_normals ? hit.shading_normal : hit.normal;
    const auto pixel = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
    return {glm::vec3(hit.position + hit.offset_m * hit.normal), glm::mat3(frame_about(axis)),
            mix_bits(mix_bits(settings.seed) ^ pixel)};
}

}  // namespace

bool find_surface(const EmbreeScene& scene, const CameraFrame& frame, int x, int y, PrimaryHits& hits,
                  SurfaceHit& hit) {
    const Camera& camera = frame.camera();
    if (!scene.first_hit(frame.ray(x + 0.5, y + 0.5), camera.near, camera.far, hit)) return false;
    hits.surface.at(x, y) = 1;
    hits.depth.at(x, y) = static_cast<float>(hit.depth);
    hits.normal.at(x, y) = glm::vec3(glm::dmat3(frame.view_from_world()) * hit.normal);
    return true;
}

TileIntegrator::TileIntegrator(const EmbreeScene& scene, const CameraFrame& frame,
                               const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                               const PointSets& points)
    : scene_(scene),
      frame_(frame),
      queries_(queries),
      settings_(settings),
      plan_(settings),
      tracer_(scene, queries, points) {}

void TileIntegrator::integrate(const Tile& tile, Truth& truth) {
    std::vector<RaySource> sources = find_sources(tile, truth);
    if (sources.empty()) return;
    tracer_.start(std::move(sources));
    samples_.assign(pixels_.size(), 0);
    trace_all();
    store(truth);
}

std::vector<RaySource> TileIntegrator::find_sources(const Tile& tile, Truth& truth) {
    std::vector<RaySource> sources;
    pixels_.clear();
    SurfaceHit hit;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (!find_surface(scene_, frame_, x, y, truth.hits, hit)) continue;
            sources.push_back(ray_source(hit, settings_, x, y));
            pixels_.push_back(truth.hits.depth.index(x, y));
        }
    }
    return sources;
}

std::vector<Estimate> TileIntegrator::estimates(std::size_t query) const {
    std::vector<PixelSpread> spreads;
    spreads.reserve(pixels_.size());
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        spreads.push_back(pixel_spread(tracer_.sums(p, query), samples_[p]));
    }
    std::vector<Estimate> all = moderated_estimates(spreads);
    if (settings_.max_error > 0) {
        for (Estimate& e : all) e.standard_error = std::min(kStoppingAllowance * e.standard_error, 0.5);
    }
    return all;
}

void TileIntegrator::trace_all() {
    std::vector<SampleRange> ranges(pixels_.size(), {0, plan_.first()});
    bool more = true;
    while (more) {
        tracer_.trace(ranges);
        for (std::size_t p = 0; p < pixels_.size(); ++p) {
            samples_[p] = ranges[p].last;
            ranges[p].first = ranges[p].last;
        }
        if (plan_.first() == plan_.most()) return;
        more = false;
        for (std::size_t q = 0; q < queries_.size(); ++q) {
            const std::vector<Estimate> now = estimates(q);
            for (std::size_t p = 0; p < pixels_.size(); ++p) {
                ranges[p].last = std::max(ranges[p].last, plan_.next(samples_[p], now[p].standard_error));
                more = more || ranges[p].last > ranges[p].first;
            }
        }
    }
}

void TileIntegrator::store(Truth& truth) const {
    for (std::size_t q = 0; q < queries_.size(); ++q) {
        const std::vector<Estimate> last = estimates(q);
        for (std::size_t p = 0; p < pixels_.size(); ++p) {
            truth.visibility[q].pixels[pixels_[p]] = static_cast<float>(last[p].visibility);
            truth.standard_error[q].pixels[pixels_[p]] = static_cast<float>(last[p].standard_error);
        }
    }
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        truth.sample_counts.pixels[pixels_[p]] = static_cast<std::uint32_t>(samples_[p]);
    }
}

}  // namespace aoscore
