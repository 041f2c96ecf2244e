#include "reference/integrator/tile_state.h"

#include "reference/sampling/sample_plan.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace aoscore {
namespace {

static_assert(kTileSide <= kLargestTile);

/// To stop where an error is estimated to be small prefers pixels whose estimate came out too small: by this
/// much, as tests over many seeds show.
constexpr double kStoppingAllowance = 1.06;

TileLawRules law_rules(const TruthQuery& query, const TruthSettings& settings) {
    const SamplePlan plan(settings);
    return {settings.max_error > 0 && plan.first() < plan.most(), query.falloff == Falloff::binary};
}

void resolve_open(std::size_t pixel, Truth& truth) {
    for (ImageF& error : truth.standard_error) error.pixels[pixel] = kProvenError;
    if (truth.bent_normal.empty()) return;
    truth.bent_normal.pixels[pixel] = 0.5f * truth.hits.normal.pixels[pixel];
    truth.cone_angle_rad.pixels[pixel] = std::numbers::pi_v<float> / 2;
    truth.bent_error_rad.pixels[pixel] = truth.cone_error_rad.pixels[pixel] = kProvenError;
}

void resolve_extras(const HitObserver::Sums& sums, double samples, std::size_t pixel, Truth& truth) {
    for (std::size_t c = 0; c < kCauses; ++c) {
        if (truth.occlusion_by_cause[c].empty()) continue;
        truth.occlusion_by_cause[c].pixels[pixel] = static_cast<float>(sums.by_cause[c] / samples);
    }
    if (!truth.one_layer_bound.empty()) {
        truth.one_layer_bound.pixels[pixel] = static_cast<float>(sums.one_layer / samples);
    }
}

void resolve_cones(const std::vector<OpenCone>& cones, const std::vector<std::size_t>& pixels,
                   const CameraFrame& frame, Truth& truth) {
    const glm::dmat3 view_from_world(frame.view_from_world());
    for (std::size_t i = 0; i < cones.size(); ++i) {
        const std::size_t pixel = pixels[i];
        const glm::vec3 bent(view_from_world * cones[i].bent_normal);
        truth.bent_normal.pixels[pixel] = bent == glm::vec3(0) ? truth.hits.normal.pixels[pixel] : bent;
        truth.bent_error_rad.pixels[pixel] = static_cast<float>(cones[i].bent_error_rad);
        truth.cone_angle_rad.pixels[pixel] = static_cast<float>(cones[i].cone_rad);
        truth.cone_error_rad.pixels[pixel] = static_cast<float>(cones[i].cone_error_rad);
    }
}

}  // namespace

std::span<const double> TileState::sums_of(std::size_t query, std::size_t queries,
                                           std::size_t surface) const {
    const std::size_t width = sums.size() / (queries * surfaces());
    return {&sums[(query * surfaces() + surface) * width], width};
}

std::vector<Estimate> stated_estimates(std::span<const PlaceInTile> places, std::span<const int> samples,
                                       const TruthQuery& query, const TruthSettings& settings,
                                       const std::function<std::span<const double>(std::size_t)>& sums) {
    std::vector<PixelSpread> spreads;
    spreads.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        spreads.push_back(pixel_spread(sums(i), samples[i], places[i]));
    std::vector<Estimate> all = moderated_estimates(spreads, law_rules(query, settings));
    if (settings.max_error > 0) {
        for (Estimate& e : all) e.standard_error = std::min(kStoppingAllowance * e.standard_error, 0.5);
    }
    return all;
}

std::vector<std::vector<double>> stated_errors(const Tile& tile, const TileState& state,
                                               const std::vector<TruthQuery>& queries,
                                               const TruthSettings& settings) {
    std::vector<std::size_t> traced;
    std::vector<PlaceInTile> places;
    std::vector<int> samples;
    for (std::size_t s = 0; s < state.surfaces(); ++s) {
        if (state.samples[s] == 0) continue;
        traced.push_back(s);
        places.push_back(place_in(tile, state.places[s]));
        samples.push_back(static_cast<int>(state.samples[s]));
    }
    std::vector<std::vector<double>> errors(queries.size());
    for (std::size_t q = 0; q < queries.size() && !traced.empty(); ++q) {
        for (const Estimate& e : stated_estimates(places, samples, queries[q], settings, [&](std::size_t i) {
                 return state.sums_of(q, queries.size(), traced[i]);
             }))
            errors[q].push_back(e.standard_error);
    }
    return errors;
}

void resolve_tile(const Tile& tile, const TileState& state, const CameraFrame& frame,
                  const ResolveRequest& request, Truth& truth) {
    std::vector<std::size_t> traced, pixels;
    std::vector<PlaceInTile> places;
    std::vector<int> samples;
    for (std::size_t s = 0; s < state.surfaces(); ++s) {
        const PlaceInTile place = place_in(tile, state.places[s]);
        const std::size_t pixel = truth.hits.depth.index(tile.x0 + place.column, tile.y0 + place.row);
        truth.hits.surface.pixels[pixel] = 1;
        truth.hits.depth.pixels[pixel] = state.depths_m[s];
        truth.hits.normal.pixels[pixel] = state.normals[s];
        truth.sample_counts.pixels[pixel] = state.samples[s];
        if (state.samples[s] == 0) {
            resolve_open(pixel, truth);
            continue;
        }
        traced.push_back(s);
        pixels.push_back(pixel);
        places.push_back(place);
        samples.push_back(static_cast<int>(state.samples[s]));
        if (!state.extras.empty())
            resolve_extras(state.extras[s], static_cast<double>(state.samples[s]), pixel, truth);
    }
    if (!truth.bent_normal.empty()) {
        std::vector<OpenSums> open_sums;
        for (const std::size_t t : traced) open_sums.push_back(state.open_sums[t]);
        resolve_cones(open_cones(open_sums, samples, law_rules(truth.queries.front(), request.settings)),
                      pixels, frame, truth);
    }
    for (std::size_t q = 0; q < request.which.size(); ++q) {
        const std::vector<Estimate> all = stated_estimates(
            places, samples, truth.queries[q], request.settings,
            [&](std::size_t i) { return state.sums_of(request.which[q], request.queries, traced[i]); });
        for (std::size_t i = 0; i < traced.size(); ++i) {
            truth.visibility[q].pixels[pixels[i]] = static_cast<float>(all[i].visibility);
            truth.standard_error[q].pixels[pixels[i]] = static_cast<float>(all[i].standard_error);
        }
    }
}

}  // namespace aoscore
