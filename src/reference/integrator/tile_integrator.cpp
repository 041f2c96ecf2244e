#include "reference/integrator/tile_integrator.h"

#include "core/sampling.h"

#include <algorithm>

namespace aoscore {
namespace {

/// Below this many rays a pixel, to prove it open costs more than to trace it.
constexpr int kLeastSamplesToSkip = 64;

glm::dvec3 ray_origin(const SurfaceHit& hit) {
    return hit.position + hit.offset_m * hit.normal;
}

/// The geometric normal in view space.
glm::vec3 view_normal(const CameraFrame& frame, const SurfaceHit& hit) {
    return glm::vec3(glm::dmat3(frame.view_from_world()) * hit.normal);
}

}  // namespace

bool see(const RayTracer& scene, const CameraFrame& frame, int x, int y, SurfaceHit& hit) {
    const Camera& camera = frame.camera();
    return scene.first_hit(frame.ray(x + 0.5, y + 0.5), camera.near, camera.far, hit);
}

bool find_surface(const RayTracer& scene, const CameraFrame& frame, int x, int y, PrimaryHits& hits,
                  SurfaceHit& hit) {
    if (!see(scene, frame, x, y, hit)) return false;
    hits.surface.at(x, y) = 1;
    hits.depth.at(x, y) = static_cast<float>(hit.depth);
    hits.normal.at(x, y) = view_normal(frame, hit);
    return true;
}

RaySource ray_source(const SurfaceHit& hit, const TruthSettings& settings, std::size_t pixel) {
    return {glm::vec3(ray_origin(hit)),
            glm::mat3(frame_about(settings.shading_normals ? hit.shading_normal : hit.normal)),
            mix_bits(mix_bits(settings.seed) ^ pixel)};
}

TileIntegrator::TileIntegrator(const ReachableScene& scene, const CameraFrame& frame,
                               const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                               const PointSets& points, const CauseJudge& judge)
    : scene_(scene.tracer),
      frame_(frame),
      queries_(queries),
      settings_(settings),
      plan_(settings),
      observer_(scene.tracer, judge, queries[0], settings.extras),
      tracer_(scene.tracer, queries, points, settings.large_triangles_first,
              settings.extras.of_hits() ? &observer_ : nullptr),
      first_query_{queries[0]},
      open_directions_(first_query_[0]),
      open_tracer_(scene.tracer, first_query_, points, false, &open_directions_, RayDensity::uniform),
      open_space_(scene.tracer, scene.within_reach) {
    for (const TruthQuery& query : queries) reach_m_ = std::max(reach_m_, query.radius_m);
}

TileState TileIntegrator::trace(const Tile& tile, const TileState* begun, SeenTile* seen) {
    if (seen == nullptr) {
        own_seen_.looked = false;
        seen = &own_seen_;
    }
    if (!seen->looked) look(tile, *seen);
    seen_ = seen;
    TileState state;
    take_surfaces(tile, state);
    list_traced(*seen);
    state.samples.assign(state.surfaces(), 0);
    if (settings_.extras.of_hits()) state.extras.assign(state.surfaces(), {});
    if (settings_.extras.bent_normals) state.open_sums.assign(state.surfaces(), {});
    if (!traced_.empty()) {
        std::vector<RaySource> sources;
        sources.reserve(traced_.size());
        for (const std::size_t s : traced_) {
            sources.push_back(ray_source(seen_->surfaces[s], settings_, pixels_[s]));
        }
        tracer_.start(std::move(sources));
        samples_.assign(traced_.size(), 0);
        if (begun != nullptr) restore(*begun);
        trace_all();
        if (settings_.extras.bent_normals) trace_open_directions();
    }
    store(state);
    return state;
}

void TileIntegrator::look(const Tile& tile, SeenTile& seen) const {
    seen.looked = true;
    seen.surfaces.clear();
    seen.places.clear();
    seen.open.reset();
    SurfaceHit hit;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (!see(scene_, frame_, x, y, hit)) continue;
            seen.surfaces.push_back(hit);
            seen.places.push_back({x - tile.x0, y - tile.y0});
        }
    }
}

void TileIntegrator::take_surfaces(const Tile& tile, TileState& state) {
    pixels_.clear();
    for (std::size_t s = 0; s < seen_->surfaces.size(); ++s) {
        const SurfaceHit& hit = seen_->surfaces[s];
        const PlaceInTile& place = seen_->places[s];
        pixels_.push_back(static_cast<std::size_t>(tile.y0 + place.row) *
                              static_cast<std::size_t>(frame_.width()) +
                          static_cast<std::size_t>(tile.x0 + place.column));
        state.places.push_back(static_cast<std::uint16_t>(place.row * (tile.x1 - tile.x0) + place.column));
        state.depths_m.push_back(static_cast<float>(hit.depth));
        state.normals.push_back(view_normal(frame_, hit));
    }
}

void TileIntegrator::list_traced(SeenTile& seen) {
    // About a smooth normal, rays may also go below the tangent plane.
    const bool skips =
        settings_.skip_open && !settings_.shading_normals && plan_.first() >= kLeastSamplesToSkip;
    if (skips && !seen.open) {
        std::vector<UpwardPoint> points;
        points.reserve(seen.surfaces.size());
        for (const SurfaceHit& hit : seen.surfaces)
            points.push_back({ray_origin(hit), hit.normal, hit.offset_m / 2});
        seen.open = open_space_.prove(points, reach_m_);
    }
    traced_.clear();
    traced_places_.clear();
    for (std::size_t s = 0; s < seen.surfaces.size(); ++s) {
        if (skips && (*seen.open)[s] != 0) continue;
        traced_.push_back(s);
        traced_places_.push_back(seen.places[s]);
    }
}

void TileIntegrator::restore(const TileState& begun) {
    // Where a pixel already has more rays than a trace from nothing would begin with, that trace might have
    // stopped earlier.
    const bool usable = begun.surfaces() == seen_->surfaces.size() && !begun.sums.empty() &&
                        std::ranges::all_of(traced_, [&](std::size_t s) {
                            return begun.samples[s] <= static_cast<std::uint32_t>(plan_.first());
                        });
    if (!usable) return;
    for (std::size_t i = 0; i < traced_.size(); ++i) {
        samples_[i] = static_cast<int>(begun.samples[traced_[i]]);
        for (std::size_t q = 0; q < queries_.size(); ++q) {
            tracer_.restore(i, q, begun.sums_of(q, queries_.size(), traced_[i]));
        }
        if (settings_.extras.of_hits()) observer_.restore(i, begun.extras[traced_[i]]);
    }
}

void TileIntegrator::trace_all() {
    std::vector<SampleRange> ranges;
    ranges.reserve(traced_.size());
    for (const int samples : samples_) ranges.push_back({samples, plan_.first()});
    bool more = true;
    while (more) {
        tracer_.trace(ranges);
        for (std::size_t i = 0; i < traced_.size(); ++i) {
            samples_[i] = ranges[i].last;
            ranges[i].first = ranges[i].last;
        }
        if (plan_.first() == plan_.most()) return;
        more = false;
        for (std::size_t q = 0; q < queries_.size(); ++q) {
            const std::vector<Estimate> now =
                stated_estimates(traced_places_, samples_, queries_[q], settings_,
                                 [&](std::size_t i) { return tracer_.sums(i, q); });
            for (std::size_t i = 0; i < traced_.size(); ++i) {
                ranges[i].last = std::max(ranges[i].last, plan_.next(samples_[i], now[i].standard_error));
                more = more || ranges[i].last > ranges[i].first;
            }
        }
    }
}

void TileIntegrator::trace_open_directions() {
    constexpr std::uint64_t kOtherPoints = 0x6f70656e;  // not those of the first set
    std::vector<RaySource> sources;
    std::vector<SampleRange> ranges;
    for (std::size_t i = 0; i < traced_.size(); ++i) {
        sources.push_back(ray_source(seen_->surfaces[traced_[i]], settings_, pixels_[traced_[i]]));
        sources.back().seed = mix_bits(sources.back().seed ^ kOtherPoints);
        ranges.push_back({0, samples_[i]});
    }
    open_tracer_.start(std::move(sources));
    open_tracer_.trace(ranges);
}

void TileIntegrator::store(TileState& state) const {
    if (traced_.empty()) return;
    const std::size_t width = tracer_.sums(0, 0).size();
    state.sums.assign(queries_.size() * state.surfaces() * width, 0);
    for (std::size_t i = 0; i < traced_.size(); ++i) {
        const std::size_t s = traced_[i];
        state.samples[s] = static_cast<std::uint32_t>(samples_[i]);
        if (settings_.extras.of_hits()) state.extras[s] = observer_.sums(i);
        if (settings_.extras.bent_normals) state.open_sums[s] = open_directions_.sums(i);
        for (std::size_t q = 0; q < queries_.size(); ++q) {
            std::ranges::copy(tracer_.sums(i, q), &state.sums[(q * state.surfaces() + s) * width]);
        }
    }
}

}  // namespace aoscore
