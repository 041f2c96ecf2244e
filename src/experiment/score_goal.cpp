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
            const double allowed =
                metric == kRankingMetric ? goal.error : ScoreGoal::kOtherMetrics * goal.error;
            excess = std::max(excess, half_width / allowed);
        }
    }
    return excess;
}

ViewRun with_samples(const ViewRun& run, int samples) {
    ViewRun more = run;
    more.work.truth.samples = samples;
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

}  // namespace

ScoreState score_state(std::span<const CellRecord> cells, const ScoreGoal& goal) {
    const double excess = largest_excess(cells, goal);
    const bool decided = !goal.every_metric && order_is_decided(ranked_values(cells));
    return {excess <= 1 || decided, excess};
}

ViewOutcome run_to_goal(const ViewRun& run, const ArtifactStore& store) {
    ViewOutcome outcome = run_view(run, store);
    if (!run.plan.score_goal) return outcome;
    const ScoreGoal& goal = *run.plan.score_goal;
    ScoreState state = score_state(outcome.cells, goal);
    for (int samples = run.work.truth.samples; !state.reached;) {
        require_in_reach(goal, state.excess, samples, outcome.view.truth_seconds, run.work.key);
        const int next = samples * (state.excess > kFar ? 4 : 2);
        log_info(
            fmt::format("{}: at {} rays a pixel the truth's noise leaves the scores {:.2g} times as wide as "
                        "asked for; going on to {}",
                        run.work.key, samples, state.excess, next));
        samples = next;
        ViewOutcome more = run_view(with_samples(run, samples), store);
        more.rays += outcome.rays;
        more.measured = std::max(more.measured, outcome.measured);
        outcome = std::move(more);
        state = score_state(outcome.cells, goal);
    }
    return outcome;
}

}  // namespace aoscore
