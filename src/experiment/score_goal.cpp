#include "experiment/score_goal.h"

#include "core/error.h"
#include "core/log.h"
#include "core/rough_text.h"
#include "metrics/intervals/mask_areas.h"
#include "metrics/roles.h"
#include "store/key.h"
#include "store/truth/truth_cache.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

/// The error that noise leaves falls with the rays N to about this power at best, as errors of scrambled
/// points do: a goal that is out of reach at this rate is out of reach, and no other is refused.
constexpr double kSlope = -0.75;
/// Beyond this a doubling was never seen to be enough, and its scores are spared.
constexpr double kFar = 8;
/// Up to this, a step of less than a doubling was seen to be enough.
constexpr double kNear = 1.4;
/// How many cells are scored to find the rays that all take.
constexpr std::size_t kProbes = 3;

/// A value that ranks, and the half width that noise leaves it.
struct Ranked {
    double value, half_width;
};

using Contestants = std::vector<const CellRecord*>;

/// The indices of cells that a goal is for. Steps are none: what a score says must not depend on them.
std::vector<std::size_t> contestant_numbers(const ViewRun& run) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < run.cells.size(); ++i) {
        if (!run.cells[i].plan.step) numbers.push_back(i);
    }
    return numbers;
}

Contestants contestants(const ViewRun& run, const std::vector<CellRecord>& cells) {
    Contestants list;
    for (const std::size_t i : contestant_numbers(run)) list.push_back(&cells[i]);
    return list;
}

std::vector<Ranked> ranked_values(const Contestants& cells) {
    std::vector<Ranked> values;
    for (const CellRecord* cell : cells) {
        const auto metric = cell->ranked.find(kRankingMetric);
        if (!cell->analysis || metric == cell->ranked.end() || !metric->second.value) continue;
        const auto noise = cell->analysis->truth_noise.find(kRankingMetric);
        if (noise != cell->analysis->truth_noise.end())
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

double largest_excess(const Contestants& cells, const ScoreGoal& goal, bool every_metric) {
    double excess = 0;
    for (const CellRecord* cell : cells) {
        if (!cell->analysis) continue;
        for (const auto& [metric, half_width] : cell->analysis->truth_noise) {
            if (is_mean_of_mask(metric) || (metric != kRankingMetric && !every_metric)) continue;
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

/// The run with a few of its cells alone, evenly chosen: nothing is kept in files, and nothing timed.
ViewRun probe_of(const ViewRun& run) {
    ViewRun probe = run;
    probe.cells.clear();
    probe.work.cells.clear();
    const std::vector<std::size_t> numbers = contestant_numbers(run);
    for (std::size_t i = 0; i < kProbes; ++i) {
        const std::size_t chosen = numbers[(2 * i + 1) * numbers.size() / (2 * kProbes)];
        probe.cells.push_back(run.cells[chosen]);
        CellWork& cell = probe.work.cells.emplace_back(run.work.cells[chosen]);
        cell.keep_image = false;
        cell.own.reset();
    }
    probe.work.own_queries.clear();
    probe.work.timed = false;
    return probe;
}

void require_in_reach(const ScoreGoal& goal, double excess, int samples, double seconds,
                      const std::string& view) {
    const double times = std::pow(excess, 1 / -kSlope);
    if (samples * times <= kMostSamples && seconds * times <= kLongestTrace_s) return;
    const double most = std::min(double{kMostSamples} / samples, kLongestTrace_s / std::max(seconds, 1e-3));
    throw usage_error(
        fmt::format("{}: a score error of {:g} takes {} rays a pixel and {} at least", view, goal.error,
                    rough_number(samples * times), rough_duration(seconds * times)),
        "--score-error",
        fmt::format("{:.2g} or more on this view", goal.error * excess * std::pow(most, kSlope)));
}

/// The next number of the form 2^k or 3 * 2^k: scrambled nets are at their best with powers of two, and two
/// steps an octave waste little.
int next_step(int samples) {
    return samples % 3 == 0 ? samples / 3 * 4 : samples / 2 * 3;
}

int more_rays(int samples, double excess, const std::string& what) {
    const int next = excess > kFar ? 4 * samples : excess > kNear ? 2 * samples : next_step(samples);
    log_info(
        fmt::format("{}: at {} rays a pixel the truth's noise leaves the scores {:.2f} times as wide as "
                    "asked for; going on to {}",
                    what, samples, excess, next));
    return next;
}

}  // namespace

double allowed_noise(const ScoreGoal& goal, std::string_view metric) {
    return metric == kRankingMetric ? goal.error : ScoreGoal::kOtherMetrics * goal.error;
}

namespace {

/// How far the truth's noise leaves a view's scores from what a goal asks for.
struct ScoreState {
    bool reached = false;
    /// The largest half width of an interval that is too wide, over the one that is allowed; 1 or less where
    /// the goal is reached.
    double excess = 0;
};

/// Of the cells that have scores; reached where none has.
ScoreState score_state(const Contestants& cells, const ScoreGoal& goal) {
    const double excess = largest_excess(cells, goal, goal.every_metric);
    const bool decided = !goal.every_metric && order_is_decided(ranked_values(cells));
    return {excess <= 1 || decided, excess};
}

/// Of the rays that the run's goal takes: they follow from what it scores, and how sure that is to be.
Key rays_key(const ViewRun& run) {
    const ViewRun first = with_rays(run, {ScoreGoal::kFirstSamples, ScoreGoal::kFirstSamples});
    KeyBuilder key("rays", "score");
    for (const std::size_t i : contestant_numbers(run)) {
        const CellKeys& cell = first.jobs.cells[i];
        key.input(cell.score);
        if (cell.own_score) key.input(*cell.own_score);
    }
    return key.value(run.plan.score_goal->error).value(run.plan.score_goal->every_metric).key();
}

/// Looks for the rays that a run's goal takes, and remembers them in the store.
class GoalSearch {
  public:
    GoalSearch(const ViewRun& run, const ArtifactStore& store)
        : run_(run), goal_(*run.plan.score_goal), store_(store) {}

    ViewOutcome run() {
        // Methods are alike in how many rays they need: a few find the number, then all are scored.
        const Key key = rays_key(run_);
        if (!store_.has(key.hex) && goal_.every_metric && contestant_numbers(run_).size() > kProbes) {
            const ViewRun probe = probe_of(run_);
            while (!enough(probe)) continue;
        }
        const std::size_t probed = outcome_.measured;
        while (!enough(run_)) continue;
        outcome_.measured = std::min(outcome_.measured + probed, run_.cells.size());
        store_.put(key.hex, {{"ranked", rays_.ranked}, {"own", rays_.own}});
        // Few rays are soon traced again, and the tiles of many queries would be most of a cache.
        forget_truth(run_.work.truth_cache, with_rays(run_, rays_).work.own_truth_request());
        return std::move(outcome_);
    }

  private:
    /// Measures the run; whether its rays are enough. Where they are not, there will be more.
    bool enough(const ViewRun& run) {
        ViewOutcome outcome = run_view(with_rays(run, rays_), store_);
        outcome.rays += outcome_.rays;
        outcome.measured = std::max(outcome.measured, outcome_.measured);
        outcome_ = std::move(outcome);
        const Contestants cells = contestants(run, outcome_.cells);
        const ScoreState state = score_state(cells, goal_);
        const double own_excess = outcome_.own_noise / goal_.error;
        // A first answer asks for less than the answer that follows it: what is out of reach for that is
        // said before there is a page.
        const double in_the_end = largest_excess(cells, goal_, true);
        if (in_the_end > 1)
            require_in_reach(goal_, in_the_end, rays_.ranked, outcome_.view.truth_seconds, run_.work.key);
        if (!state.reached) {
            rays_.ranked = more_rays(rays_.ranked, state.excess, run_.work.key);
        }
        if (own_excess > 1)
            rays_.own = more_rays(rays_.own, own_excess, run_.work.key + ", methods' own truths");
        return state.reached && own_excess <= 1;
    }

    const ViewRun& run_;
    const ScoreGoal& goal_;
    const ArtifactStore& store_;
    Rays rays_{run_.work.truth.samples, run_.work.own_truth.samples};
    ViewOutcome outcome_;
};

}  // namespace

ViewRun with_known_rays(const ViewRun& run, const ArtifactStore& store) {
    if (!run.plan.score_goal) return run;
    const std::optional<nlohmann::json> found = store.find(rays_key(run).hex);
    if (!found || !found->is_object()) return run;
    const Rays first{run.work.truth.samples, run.work.own_truth.samples};
    return with_rays(run, {found->value("ranked", first.ranked), found->value("own", first.own)});
}

ViewOutcome run_to_goal(const ViewRun& run, const ArtifactStore& store) {
    if (!run.plan.score_goal) return run_view(run, store);
    return GoalSearch(run, store).run();
}

}  // namespace aoscore
