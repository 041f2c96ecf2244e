#include "reference/integrator/mean_error_pilot.h"

#include "core/interrupt.h"
#include "core/progress.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/sampling/point_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace aoscore {
namespace {

/// No measurement has more chunks of tiles: a store numbers them in turn.
constexpr std::size_t kMostChunks = 1 << 24;

TruthSettings even_rays_alone(const TruthSettings& settings) {
    TruthSettings alone = settings;
    alone.mean_error = 0;
    alone.extras = {};
    return alone;
}

}  // namespace

MeanErrorPilot::MeanErrorPilot(const ReachableScene& scene, const CameraFrame& frame,
                               const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                               const CauseJudge& judge, TileStore* store, const std::string& what,
                               const TellRays& tell)
    : scene_(scene),
      frame_(frame),
      queries_(queries),
      judge_(judge),
      settings_(even_rays_alone(settings)),
      usable_(!settings.extras.any()),
      store_(store),
      what_(what),
      tiles_(spread_tiles(frame.width(), frame.height())) {
    rays_ = rays_for_mean_error(
        settings.mean_error, tiles_.size(), settings.samples,
        [this](std::size_t tiles, int samples) { return trace_first(tiles, samples); }, tell);
    for (std::size_t i = 0; usable_ && i < states_.size(); ++i)
        numbers_.emplace(std::pair(tiles_[i].tile.y0, tiles_[i].tile.x0), i);
}

MeanErrorPilot::Begun MeanErrorPilot::begun(const Tile& tile) {
    const auto found = numbers_.find({tile.y0, tile.x0});
    if (found == numbers_.end()) return {};
    const TileState& state = states_[found->second];
    return {&state, &seen_[found->second], state.surfaces() == 0 || samples_[found->second] == rays_.samples};
}

PilotMeasure MeanErrorPilot::trace_first(std::size_t tiles, int samples) {
    settings_.samples = samples;
    const PointSets points(settings_.points, samples);
    states_.resize(std::max(states_.size(), tiles));
    samples_.resize(states_.size());
    seen_.resize(states_.size());
    std::fill_n(samples_.begin(), tiles, samples);
    PilotMeasure measured{.tiles = std::vector<TileErrors>(tiles)};
    const std::size_t at_a_time = tiles_at_a_time(tiles);
    const std::size_t chunks = (tiles + at_a_time - 1) / at_a_time;
    const std::size_t measure = measures_++;
    std::atomic<double> seconds{0};
    std::optional<Progress> progress;
    if (!what_.empty()) {
        progress.emplace(fmt::format("{}: how many rays, {} of {} tiles with {} a pixel", what_, tiles,
                                     tiles_.size(), samples),
                         chunks);
    }
    parallel_for(chunks, [&](std::size_t chunk) {
        const FlushDenormals flush;
        const Stopwatch watch;
        const std::size_t begin = chunk * at_a_time, end = std::min(tiles, begin + at_a_time);
        const std::size_t number = measure * kMostChunks + chunk;
        GroupState group;
        if (store_ != nullptr && store_->has(number)) {
            group = store_->load(number);
        } else {
            TileIntegrator integrator(scene_, frame_, queries_, settings_, points, judge_);
            for (std::size_t i = begin; i < end; ++i) {
                throw_if_interrupted();
                group.tiles.push_back(integrator.trace(tiles_[i].tile, &states_[i], &seen_[i]));
            }
            traced_rays_ += integrator.rays();
            group.seconds = watch.seconds();
            if (store_ != nullptr) store_->keep(number, group);
        }
        seconds += group.seconds;
        for (std::size_t i = begin; i < end; ++i) {
            states_[i] = std::move(group.tiles[i - begin]);
            measured.tiles[i] = errors_of(tiles_[i], states_[i]);
        }
        if (progress) progress->step();
    });
    measured.seconds = seconds / thread_count();
    return measured;
}

TileErrors MeanErrorPilot::errors_of(const SpreadTile& tile, const TileState& state) const {
    TileErrors errors{.error_sums = {}, .surfaces = state.surfaces(), .place = tile.place};
    for (const std::vector<double>& of_query : stated_errors(tile.tile, state, queries_, settings_))
        errors.error_sums.push_back(std::accumulate(of_query.begin(), of_query.end(), 0.0));
    return errors;
}

}  // namespace aoscore
