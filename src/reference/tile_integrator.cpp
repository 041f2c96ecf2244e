#include "reference/tile_integrator.h"

#include "core/sampling.h"

#include <algorithm>
#include <numbers>

namespace aoscore {
namespace {

/// To stop where an error is estimated to be small prefers pixels whose estimate came out too small: by this
/// much, as tests over many seeds show.
constexpr double kStoppingAllowance = 1.06;

/// Below this many rays a pixel, to prove it open costs more than to trace it.
constexpr int kLeastSamplesToSkip = 32;

glm::dvec3 ray_origin(const SurfaceHit& hit) {
    return hit.position + hit.offset_m * hit.normal;
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

RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, std::size_t pixel) {
    return {glm::vec3(ray_origin(hit)),
            glm::mat3(frame_about(settings.shading_normals ? hit.shading_normal : hit.normal)),
            mix_bits(mix_bits(settings.seed) ^ pixel)};
}

double cone_angle_rad(const glm::dvec3& bent_normal) {
    return std::numbers::pi / 2 * (1 - std::clamp(2 * glm::length(bent_normal) - 1, 0.0, 1.0));
}

TileIntegrator::TileIntegrator(const EmbreeScene& scene, const CameraFrame& frame,
                               const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                               const PointSets& points, const CauseJudge& judge)
    : scene_(scene),
      frame_(frame),
      queries_(queries),
      settings_(settings),
      plan_(settings),
      observer_(scene, judge, queries[0], settings.extras),
      tracer_(scene, queries, points, settings.extras.any() ? &observer_ : nullptr),
      open_space_(scene) {
    for (const TruthQuery& query : queries) reach_m_ = std::max(reach_m_, query.radius_m);
}

void TileIntegrator::integrate(const Tile& tile, Truth& truth) {
    find_surfaces(tile, truth.hits);
    // About a smooth normal, rays may also go below the tangent plane.
    if (settings_.skip_open && !settings_.shading_normals && plan_.first() >= kLeastSamplesToSkip)
        skip_open(truth);
    if (surfaces_.empty()) return;
    std::vector<RaySource> sources;
    sources.reserve(surfaces_.size());
    for (std::size_t p = 0; p < surfaces_.size(); ++p) {
        sources.push_back(ray_source(surfaces_[p], settings_, pixels_[p]));
    }
    tracer_.start(std::move(sources));
    samples_.assign(pixels_.size(), 0);
    trace_all();
    store(truth);
}

void TileIntegrator::find_surfaces(const Tile& tile, PrimaryHits& hits) {
    surfaces_.clear();
    pixels_.clear();
    SurfaceHit hit;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (!find_surface(scene_, frame_, x, y, hits, hit)) continue;
            surfaces_.push_back(hit);
            pixels_.push_back(hits.depth.index(x, y));
        }
    }
}

void TileIntegrator::skip_open(Truth& truth) {
    std::vector<UpwardPoint> points;
    points.reserve(surfaces_.size());
    for (const SurfaceHit& hit : surfaces_) points.push_back({ray_origin(hit), hit.normal, hit.offset_m / 2});
    const std::vector<char> open = open_space_.prove(points, reach_m_);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        if (open[p] == 0) {
            surfaces_[kept] = surfaces_[p];
            pixels_[kept++] = pixels_[p];
            continue;
        }
        for (ImageF& error : truth.standard_error) error.pixels[pixels_[p]] = kProvenError;
        if (settings_.extras.bent_normals) {
            truth.bent_normal.pixels[pixels_[p]] = 0.5f * truth.hits.normal.pixels[pixels_[p]];
            truth.cone_angle_rad.pixels[pixels_[p]] = std::numbers::pi_v<float> / 2;
        }
    }
    open_pixels_ += pixels_.size() - kept;
    surfaces_.resize(kept);
    pixels_.resize(kept);
}

std::vector<Estimate> TileIntegrator::estimates(std::size_t query) const {
    std::vector<PixelSpread> spreads;
    spreads.reserve(pixels_.size());
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        spreads.push_back(pixel_spread(tracer_.sums(p, query), samples_[p]));
    }
    std::vector<Estimate> all = moderated_estimates(spreads, plan_.first() < plan_.most());
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
        if (settings_.extras.any()) store_extras(p, truth);
    }
}

void TileIntegrator::store_extras(std::size_t surface, Truth& truth) const {
    const HitObserver::Sums& sums = observer_.sums(surface);
    const std::size_t pixel = pixels_[surface];
    const double samples = samples_[surface];
    if (settings_.extras.causes) {
        for (std::size_t c = 0; c < kCauses; ++c) {
            truth.occlusion_by_cause[c].pixels[pixel] = static_cast<float>(sums.by_cause[c] / samples);
        }
    }
    if (settings_.extras.one_layer_bound) {
        truth.one_layer_bound.pixels[pixel] = static_cast<float>(sums.one_layer / samples);
    }
    if (settings_.extras.bent_normals) {
        const glm::dvec3 bent = glm::dmat3(frame_.view_from_world()) * (sums.open_direction / samples);
        truth.bent_normal.pixels[pixel] = glm::vec3(bent);
        truth.cone_angle_rad.pixels[pixel] = static_cast<float>(cone_angle_rad(bent));
    }
}

}  // namespace aoscore
