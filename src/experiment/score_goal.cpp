#include "experiment/score_goal.h"

#include "core/error.h"
#include "core/log.h"
#include "metrics/roles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// What noise leaves falls with the rays N to about this power at best, as errors of scrambled points do: a
/// goal that is out of reach at this rate is out of reach, and no other is refused.
constexpr double kSlope = -0.75;
constexpr double kDay_s = 86400;
/// Beyond this a doubling was never seen to be enough, and its scores are spared.
constexpr double kFar = 8;

/// A value that ranks, and the half width that noise leaves it.
struct Ranked {
    double value, half_width;
};

std::vector<Ranked> ranked_values(std::span<const CellRecord> cells) {
    std::vector<Ranked> values;
    for (const CellRecord& cell : cells) {
        const auto metric = cell.ranked.find(kRankingMetric);
        if (!cell.analysis || metric == cell.ranked.end() || !metric->second.value) continue;
        const auto noise = cell.analysis->truth_noise.find(kRankingMetric);
        if (noise != cell.analysis->truth_noise.end())
            values.push_back({*metric->second.value, noise->second});
    }
    return values;
}

/// Whether noise cannot change the order. Noise moves two methods alike, so that their difference is surer
/// than this sum of both says.
bool order_is_decided(std::vector<Ranked> values) {
    std::ranges::sort(values, {}, &Ranked::value);
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (values[i].value - values[i - 1].value <= values[i].half_width + values[i - 1].half_width)
            return false;
    }
    return true;
}

double largest_excess(std::span<const CellRecord> cells, const ScoreGoal& goal) {
    double excess = 0;
    for (const CellRecord& cell : cells) {
        if (!cell.analysis) continue;
        for (const auto& [metric, half_width] : cell.analysis->truth_noise) {
            if (metric != kRankingMetric && !goal.every_metric) continue;
            excess = std::max(excess, half_width / allowed_noise(goal, metric));
        }
    }
    return excess;
}

/// Rays a pixel of the view's truth and of the methods' own.
struct Rays {
    int ranked, own;
};

ViewRun with_rays(const ViewRun& run, const Rays& rays) {
    ViewRun more = run;
    more.work.truth.samples = rays.ranked;
    more.work.own_truth.samples = rays.own;
    more.jobs = view_jobs(more.work);
    return more;
}

void require_in_reach(const ScoreGoal& goal, double excess, int samples, double seconds,
                      const std::string& view) {
    const double times = std::pow(excess, 1 / -kSlope);
    if (samples * times <= kMostSamples && seconds * times <= kDay_s) return;
    const double most = std::min(double{kMostSamples} / samples, kDay_s / std::max(seconds, 1e-3));
    throw usage_error(
        fmt::format("{}: a score error of {:g} takes {:.3g} rays a pixel and {:.3g} hours at least", view,
                    goal.error, samples * times, seconds * times / 3600),
        "--score-error",
        fmt::format("{:.2g} or more on this view", goal.error * excess * std::pow(most, kSlope)));
}

int more_rays(int samples, double excess, const std::string& what) {
    const int next = samples * (excess > kFar ? 4 : 2);
    log_info(
        fmt::format("{}: at {} rays a pixel the truth's noise leaves the scores {:.2g} times as wide as "
                    "asked for; going on to {}",
                    what, samples, excess, next));
    return next;
}

}  // namespace

double allowed_noise(const ScoreGoal& goal, std::string_view metric) {
    return metric == kRankingMetric ? goal.error : ScoreGoal::kOtherMetrics * goal.error;
}

ScoreState score_state(std::span<const CellRecord> cells, const ScoreGoal& goal) {
    const double excess = largest_excess(cells, goal);
    const bool decided = !goal.every_metric && order_is_decided(ranked_values(cells));
    return {excess <= 1 || decided, excess};
}

ViewOutcome run_to_goal(const ViewRun& run, const ArtifactStore& store) {
    ViewOutcome outcome = run_view(run, store);
    if (!run.plan.score_goal) return outcome;
    const ScoreGoal& goal = *run.plan.score_goal;
    for (Rays rays{run.work.truth.samples, run.work.own_truth.samples};;) {
        const ScoreState state = score_state(outcome.cells, goal);
        const double own_excess = outcome.own_noise / goal.error;
        if (state.reached && own_excess <= 1) return outcome;
        if (!state.reached) {
            require_in_reach(goal, state.excess, rays.ranked, outcome.view.truth_seconds, run.work.key);
            rays.ranked = more_rays(rays.ranked, state.excess, run.work.key);
        }
        if (own_excess > 1)
            rays.own = more_rays(rays.own, own_excess, run.work.key + ", methods' own truths");
        ViewOutcome more = run_view(with_rays(run, rays), store);
        more.rays += outcome.rays;
        more.measured = std::max(more.measured, outcome.measured);
        outcome = std::move(more);
    }
}

}  // namespace aoscore
