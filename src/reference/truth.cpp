#include "reference/truth.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/log.h"
#include "core/progress.h"
#include "core/rough_text.h"
#include "core/stopwatch.h"
#include "core/threads.h"
#include "reference/integrator/error_forecast.h"
#include "reference/integrator/flush_denormals.h"
#include "reference/integrator/mean_error_pilot.h"
#include "reference/integrator/tile.h"
#include "reference/integrator/tile_integrator.h"
#include "reference/integrator/tile_state.h"
#include "reference/integrator/tile_store.h"
#include "reference/integrator/truth_resolve.h"
#include "reference/sampling/sample_plan.h"
#include "reference/tracer/scene_builds.h"
#include "reference/truth_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace aoscore {
namespace {

PrimaryHits hits_in(const RayTracer& scene, const CameraFrame& frame) {
    PrimaryHits found = empty_hits(frame.width(), frame.height());
    const std::vector<Tile> tiles = tiles_of(frame.width(), frame.height());
    parallel_for(tiles.size(), [&](std::size_t i) {
        throw_if_interrupted();
        const FlushDenormals flush;
        const Tile& tile = tiles[i];
        SurfaceHit hit;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) find_surface(scene, frame, x, y, found, hit);
        }
    });
    return found;
}

/// How far rays reach that serve all of them, metres.
double longest_radius(const std::vector<TruthQuery>& queries) {
    double radius_m = 0;
    for (const TruthQuery& query : queries) radius_m = std::max(radius_m, query.radius_m);
    return radius_m;
}

/// Rays of a picture, so far as that can be said before there are any.
double expected_rays(const CameraFrame& frame, const TruthSettings& settings) {
    if (settings.mean_error > 0) return std::numeric_limits<double>::infinity();
    return static_cast<double>(frame.width()) * frame.height() * SamplePlan(settings).first();
}

/// Whether an error for every pixel takes so long, at its least, that to say how long first costs little.
bool may_take_long(const CameraFrame& frame, const TruthSettings& settings) {
    constexpr double kManyRays = 1e8;
    return settings.max_error > 0 && expected_rays(frame, settings) > kManyRays;
}

/// Says where pixels got all the rays that a pixel can have and yet err more than was asked for.
void say_what_stopped_short(const Truth& truth, const TruthSettings& settings, const std::string& what) {
    if (settings.max_error <= 0) return;
    std::size_t short_of_it = 0;
    for (std::size_t i = 0; i < truth.sample_counts.size(); ++i) {
        const auto errs = [&](const ImageF& error) { return error.pixels[i] > settings.max_error; };
        short_of_it +=
            truth.sample_counts.pixels[i] >= kMostSamples && std::ranges::any_of(truth.standard_error, errs);
    }
    if (short_of_it == 0) return;
    log_warning(fmt::format("{}: {} pixels err by more than {:g} with {} rays, the most that a pixel gets",
                            what, short_of_it, settings.max_error, kMostSamples));
}

/// The settings with the rays that a pilot found, where there is one.
TruthSettings settled(TruthSettings settings, const MeanErrorPilot* pilot) {
    if (pilot == nullptr) return settings;
    settings.mean_error = 0;
    settings.samples = pilot->rays().samples;
    return settings;
}

/// The state that all threads share while they trace one truth.
struct TraceWork {
    /// `what` names the work where a pilot says how much there is of it; empty: it says nothing. `store` may
    /// be null.
    TraceWork(const ReachableScene& within_reach, const CameraFrame& f, const std::vector<TruthQuery>& q,
              const TruthSettings& s, TileStore* store = nullptr, const std::string& what = {})
        : scene(within_reach),
          frame(f),
          queries(q),
          hits(s.extras.of_hits() ? hits_in(scene.tracer, frame) : PrimaryHits{}),
          judge(scene.tracer, frame, hits),
          pilot(pilot_for(s, store, what)),
          settings(settled(s, pilot.get())),
          points(s.points, SamplePlan(settings).most()) {}

    std::unique_ptr<MeanErrorPilot> pilot_for(const TruthSettings& asked, TileStore* store,
                                              const std::string& what) const {
        if (asked.mean_error <= 0) return nullptr;
        const auto tell = [&](const EvenRays& rays) {
            if (what.empty()) return;
            log_info(fmt::format(
                "{}: a mean error of {:g} takes roughly {} rays a pixel and {}; how many it "
                "takes exactly is found first",
                what, asked.mean_error, rough_number(rays.samples), rough_duration(rays.seconds)));
        };
        auto found = std::make_unique<MeanErrorPilot>(
            scene, frame, queries, asked, judge, store != nullptr ? store->of_search() : nullptr, what, tell);
        if (!what.empty()) {
            log_info(fmt::format("{}: a mean error of {:g} takes {} rays a pixel", what, asked.mean_error,
                                 found->rays().samples));
        }
        return found;
    }

    /// A group of tiles, from what is there of them; adds the rays that it traced to `rays`.
    GroupState trace(std::span<const Tile> tiles, const GroupState& begun, std::uint64_t& rays) const {
        const FlushDenormals flush;
        const Stopwatch watch;
        TileIntegrator integrator(scene, frame, queries, settings, points, judge);
        GroupState state;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            throw_if_interrupted();
            const MeanErrorPilot::Begun tried = pilot ? pilot->begun(tiles[i]) : MeanErrorPilot::Begun{};
            if (tried.done) {
                state.tiles.push_back(*tried.state);
                continue;
            }
            const TileState* there = tried.state;
            if (there == nullptr && !begun.tiles.empty()) there = &begun.tiles[i];
            state.tiles.push_back(integrator.trace(tiles[i], there, tried.seen));
            if (tried.seen != nullptr) *tried.seen = {};  // this was the last visit
        }
        state.seconds = begun.seconds + watch.seconds();
        rays += integrator.rays();
        return state;
    }

    const ReachableScene& scene;
    const CameraFrame& frame;
    const std::vector<TruthQuery>& queries;
    const PrimaryHits hits;  // what is hidden shows only once the whole picture is there
    const CauseJudge judge;
    const std::unique_ptr<MeanErrorPilot> pilot;  // where a mean error is asked for
    const TruthSettings settings;
    const PointSets points;
};

}  // namespace

void check_truth_request(const std::vector<TruthQuery>& queries, const TruthSettings& settings) {
    if (settings.samples < 1 || settings.samples > kMostSamples) {
        throw usage_error(fmt::format("{} samples a pixel", settings.samples), "samples",
                          fmt::format("1 to {}", kMostSamples));
    }
    if (!(settings.max_error >= 0 && settings.max_error < 1)) {
        throw usage_error(fmt::format("error of {}", settings.max_error), "error", "0 (off) or less than 1");
    }
    if (!(settings.mean_error >= 0 && settings.mean_error < 1)) {
        throw usage_error(fmt::format("mean error of {}", settings.mean_error), "mean error",
                          "0 (off) or less than 1");
    }
    for (const double error : {settings.max_error, settings.mean_error}) {
        if (error > 0 && error < kLeastError)
            throw usage_error(fmt::format("error of {:g}, below the rounding of float32 numbers", error),
                              "error", fmt::format("{:g} or more", kLeastError));
    }
    if (settings.max_error > 0 && settings.mean_error > 0) {
        throw usage_error("an error for every pixel and one for the mean", "error", "one of them");
    }
    if (settings.halves && (settings.samples % 2 != 0 || settings.max_error > 0 || settings.mean_error > 0)) {
        throw usage_error("two halves of an odd number of rays, or of one that an error decides", "samples",
                          "an even number, and no error");
    }
    if (queries.empty()) throw usage_error("no radius to trace", "radius", "at least one");
    for (const TruthQuery& query : queries) {
        if (!(query.radius_m > 0)) {
            throw usage_error(fmt::format("radius {} m", query.radius_m), "radius",
                              "more than 0, or infinity");
        }
        if (query.falloff == Falloff::alchemy && !(query.u_m > 0 && std::isfinite(query.u_m))) {
            throw usage_error(fmt::format("u is {} m", query.u_m), "u", "more than 0, finite");
        }
    }
}

ReferenceScene::ReferenceScene(const Scene& scene, const TraceBuild& build)
    : ReferenceScene(std::make_unique<Impl>(scene, build)) {
    impl_->builds.build_whole();
}
ReferenceScene::ReferenceScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ReferenceScene ReferenceScene::built_when_needed(const Scene& scene, const TraceBuild& build) {
    return ReferenceScene(std::make_unique<Impl>(scene, build));
}
ReferenceScene::~ReferenceScene() = default;
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;
ReferenceScene& ReferenceScene::operator=(ReferenceScene&&) noexcept = default;

std::size_t ReferenceScene::peak_bytes() const {
    return impl_->builds.peak_bytes();
}

const TraceBuild& ReferenceScene::build() const {
    return impl_->builds.build();
}

PrimaryHits ReferenceScene::primary_hits(const CameraFrame& frame) const {
    return hits_in(impl_->builds.reachable(frame, 0).tracer, frame);
}

Truth ReferenceScene::trace(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                            const TruthSettings& settings, const std::string& what, TileStore* store) const {
    check_truth_request(queries, settings);
    if (settings.halves) throw internal_error("halves are traced one after the other");
    const TileGroups groups(frame.width(), frame.height());
    const std::vector<std::size_t> all_queries = numbers_up_to(queries.size());
    const ResolveRequest request{queries.size(), all_queries, settings};
    Truth truth = empty_truth(frame, queries, settings.extras);
    std::vector<std::size_t> kept, wanted;
    for (std::size_t g = 0; g < groups.count(); ++g) {
        (store != nullptr && store->has(g) ? kept : wanted).push_back(g);
    }
    if (!kept.empty()) resolve_kept(groups, kept, *store, frame, request, truth);

    if (wanted.empty()) {
        count_samples(settings, truth);
        return truth;
    }
    const ReachableScene scene =
        impl_->builds.reachable(frame, longest_radius(queries), expected_rays(frame, settings));
    truth.left_out_triangles = scene.left_out_triangles;
    const TraceWork work(scene, frame, queries, settings, store, what);
    if (kept.empty() && may_take_long(frame, settings)) {
        const ErrorForecast forecast = forecast_error(scene, frame, queries, settings, work.judge);
        require_in_reach(forecast, settings.max_error);
        log_info(fmt::format("{}: {}", what, forecast_text(forecast, settings.max_error)));
    }
    Progress progress(what, wanted.size());
    std::atomic<std::uint64_t> rays{work.pilot ? work.pilot->traced_rays() : 0};
    const Stopwatch watch;
    const auto bring = [&](std::size_t g) {
        if (store != nullptr && store->has(g)) {
            resolve_group(groups, g, store->load(g).tiles, frame, request, truth);
        } else {
            std::uint64_t group_rays = 0;
            const GroupState begun = store != nullptr ? store->begun(g) : GroupState{};
            const GroupState state = work.trace(groups.group(g), begun, group_rays);
            if (store != nullptr) store->keep(g, state);
            resolve_group(groups, g, state.tiles, frame, request, truth);
            rays += group_rays;
        }
        progress.step();
    };
    std::vector<char> later(wanted.size(), 0);
    parallel_for(wanted.size(), [&](std::size_t i) {
        later[i] = store != nullptr && store->begun_elsewhere(wanted[i]) ? 1 : 0;
        if (later[i] == 0) bring(wanted[i]);
    });
    parallel_for(wanted.size(), [&](std::size_t i) {
        if (later[i] != 0) bring(wanted[i]);
    });
    truth.seconds += watch.seconds();
    truth.rays_now = rays;
    count_samples(settings, truth);
    say_what_stopped_short(truth, settings, what);
    return truth;
}

void ReferenceScene::trace_into(TileStore& store, const CameraFrame& frame,
                                const std::vector<TruthQuery>& queries, const TruthSettings& settings,
                                const std::function<std::vector<std::size_t>()>& next) const {
    check_truth_request(queries, settings);
    std::vector<std::size_t> numbers = next();
    if (numbers.empty()) return;
    const ReachableScene scene = impl_->builds.reachable(frame, longest_radius(queries));
    const TraceWork work(scene, frame, queries, settings);
    const TileGroups groups(frame.width(), frame.height());
    for (; !numbers.empty(); numbers = next()) {
        parallel_for(numbers.size(), [&](std::size_t i) {
            std::uint64_t rays = 0;
            store.keep(numbers[i], work.trace(groups.group(numbers[i]), store.begun(numbers[i]), rays));
        });
    }
}

std::vector<GroupState> ReferenceScene::trace_groups(const CameraFrame& frame,
                                                     const std::vector<TruthQuery>& queries,
                                                     const TruthSettings& settings,
                                                     const std::vector<std::size_t>& numbers) const {
    check_truth_request(queries, settings);
    const ReachableScene scene = impl_->builds.reachable(frame, longest_radius(queries));
    const TraceWork work(scene, frame, queries, settings);
    const TileGroups groups(frame.width(), frame.height());
    std::vector<GroupState> states(numbers.size());
    parallel_for(numbers.size(), [&](std::size_t i) {
        std::uint64_t rays = 0;
        states[i] = work.trace(groups.group(numbers[i]), {}, rays);
    });
    return states;
}

}  // namespace aoscore
