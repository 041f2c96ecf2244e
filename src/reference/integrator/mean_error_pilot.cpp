#include "reference/integrator/mean_error_pilot.h"

#include "core/interrupt.h"
#include "core/threads.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/tile_integrator.h"
#include "reference/sampling/point_sets.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace aoscore {
namespace {

TruthSettings even_rays_alone(const TruthSettings& settings) {
    TruthSettings alone = settings;
    alone.mean_error = 0;
    alone.extras = {};
    return alone;
}

}  // namespace

MeanErrorPilot::MeanErrorPilot(const ReachableScene& scene, const CameraFrame& frame,
                               const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                               const CauseJudge& judge, const TellRays& tell)
    : scene_(scene),
      frame_(frame),
      queries_(queries),
      judge_(judge),
      settings_(even_rays_alone(settings)),
      usable_(!settings.extras.any()),
      tiles_(random_tiles(frame.width(), frame.height(), std::numeric_limits<std::size_t>::max())) {
    rays_ = rays_for_mean_error(
        settings.mean_error, tiles_.size(), settings.samples,
        [this](std::size_t tiles, int samples) { return trace_first(tiles, samples); }, tell);
    for (std::size_t i = 0; usable_ && i < states_.size(); ++i)
        numbers_.emplace(std::pair(tiles_[i].y0, tiles_[i].x0), i);
}

const TileState* MeanErrorPilot::state_of(const Tile& tile) const {
    const auto found = numbers_.find({tile.y0, tile.x0});
    return found == numbers_.end() ? nullptr : &states_[found->second];
}

bool MeanErrorPilot::is_done(const TileState& state) const {
    const auto samples = static_cast<std::uint32_t>(rays_.samples);
    return std::ranges::any_of(state.samples, [&](std::uint32_t n) { return n == samples; });
}

std::vector<TileErrors> MeanErrorPilot::trace_first(std::size_t tiles, int samples) {
    settings_.samples = samples;
    const PointSets points(settings_.points, samples);
    states_.resize(std::max(states_.size(), tiles));
    std::vector<TileErrors> errors(tiles);
    const std::size_t at_a_time = tiles_at_a_time(tiles);
    parallel_for((tiles + at_a_time - 1) / at_a_time, [&](std::size_t chunk) {
        const FlushDenormals flush;
        TileIntegrator integrator(scene_, frame_, queries_, settings_, points, judge_);
        const std::size_t end = std::min(tiles, (chunk + 1) * at_a_time);
        for (std::size_t i = chunk * at_a_time; i < end; ++i) {
            throw_if_interrupted();
            states_[i] = integrator.trace(tiles_[i], &states_[i]);
            errors[i] = errors_of(tiles_[i], states_[i]);
        }
    });
    return errors;
}

TileErrors MeanErrorPilot::errors_of(const Tile& tile, const TileState& state) const {
    TileErrors errors{.error_sums = {}, .surfaces = state.surfaces()};
    std::vector<std::size_t> traced;
    std::vector<PlaceInTile> places;
    std::vector<int> samples;
    for (std::size_t s = 0; s < state.surfaces(); ++s) {
        if (state.samples[s] == 0) continue;
        traced.push_back(s);
        places.push_back(place_in(tile, state.places[s]));
        samples.push_back(static_cast<int>(state.samples[s]));
    }
    for (std::size_t q = 0; q < queries_.size() && !traced.empty(); ++q) {
        double sum = 0;
        for (const Estimate& e :
             stated_estimates(places, samples, queries_[q], settings_,
                              [&](std::size_t i) { return state.sums_of(q, queries_.size(), traced[i]); }))
            sum += e.standard_error;
        errors.error_sums.push_back(sum);
    }
    return errors;
}

}  // namespace aoscore
