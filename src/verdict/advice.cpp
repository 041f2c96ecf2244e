#include "verdict/advice.h"

#include "core/error.h"
#include "core/known_names.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/drawn_sums.h"
#include "metrics/intervals/median_interval.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace aoscore {
namespace {

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The metric's value by the sums of all blocks.
double value_by_sums(const std::string& id, const BlockErrors& blocks) {
    DrawnSums sums;
    sums.count = sum_of(blocks.counts);
    sums.squared = sum_of(blocks.squared_sums);
    sums.variance = sum_of(blocks.variance_sums);
    return metric(id).resampled(sums);
}

Resampled resampled_errors(const std::string& metric_id, double value, const BlockErrors& blocks,
                           std::uint64_t seed) {
    const std::array<const BlockErrors*, 1> images{&blocks};
    return {value, resampled(metric_id, images, seed)};
}

/// A time with the interval of its median.
struct Cost {
    double ms = 0;
    std::optional<Interval> interval;
};

std::optional<Cost> median_cost(const Timing& timing) {
    if (!timing.median_ms) return std::nullopt;
    Cost cost{*timing.median_ms, {}};
    if (const auto interval = median_interval(timing.runs_ms))
        cost.interval = Interval{interval->low, interval->high};
    return cost;
}

Cost sum(const Cost& a, const Cost& b) {
    Cost both{a.ms + b.ms, {}};
    if (a.interval && b.interval)
        both.interval = Interval{a.interval->low + b.interval->low, a.interval->high + b.interval->high};
    return both;
}

Cost less(const Cost& a, const Cost& b) {
    Cost negative{-b.ms, {}};
    if (b.interval) negative.interval = Interval{-b.interval->high, -b.interval->low};
    return sum(a, negative);
}

Cost scaled(Cost cost, double factor) {
    cost.ms *= factor;
    if (cost.interval) cost.interval = Interval{cost.interval->low * factor, cost.interval->high * factor};
    return cost;
}

/// The times that make a cell's cost.
struct CellTimes {
    Timing ao, filter, gbuffer, shared_gbuffer, fixed_pass;

    std::array<Timing*, 5> all() { return {&ao, &filter, &gbuffer, &shared_gbuffer, &fixed_pass}; }
};

CellTimes times_of(const CellRecord& cell, const ViewRecord& view) {
    return {cell.ao, cell.filter_pass, cell.gbuffer, view.gbuffer, cell.fixed_pass};
}

/// Whether every run has processor time too.
bool has_processor_time(CellTimes times) {
    return !times.ao.processor_runs_ms.empty() && std::ranges::all_of(times.all(), [](const Timing* timing) {
        return timing->processor_runs_ms.size() == timing->runs_ms.size();
    });
}

/// Processor time of all threads in place of the clock's, which another load of the machine moves.
CellTimes on_processor(CellTimes times) {
    for (Timing* timing : times.all()) {
        if (timing->processor_runs_ms.empty()) continue;
        timing->runs_ms = timing->processor_runs_ms;
        timing->median_ms = median(timing->runs_ms);
    }
    return times;
}

/// What a cell adds to a frame: its passes, and what its own G-buffer takes more than the view's.
std::optional<Cost> cost_of(const CellTimes& times) {
    std::optional<Cost> cost = median_cost(times.ao);
    if (!cost) return std::nullopt;
    if (const auto filter = median_cost(times.filter)) cost = sum(*cost, *filter);
    const auto own = median_cost(times.gbuffer), shared = median_cost(times.shared_gbuffer);
    if (own && shared) cost = sum(*cost, less(*own, *shared));
    return cost;
}

/// Takes the steps of one cell from the results, and compares them.
class StepsOfOne {
  public:
    StepsOfOne(const AdvicePlan& plan, std::span<const std::string> ids, const Results& results)
        : plan_(plan),
          ids_(ids),
          results_(results),
          cell_(cell_of(plan.cell_index)),
          view_(*find_row(results.views, cell_.view_key, &ViewRecord::key)) {}

    AdviceRecord judged() {
        advice_.cell_id = cell_.id;
        advice_.metric = ranking_metric({&cell_});
        advice_.skipped = plan_.skipped;
        const std::optional<double> error = ranked_value(cell_, advice_.metric);
        if (!error || !cell_.analysis) return std::move(advice_);
        advice_.error = *error;
        advice_.fetches = cell_.fetches_per_pixel;
        by_processor_ = has_processor_time(times_of(cell_, view_)) &&
                        std::ranges::all_of(plan_.steps, [&](const StepPlan& step) {
                            return !step.cell_index || has_times_alike(cell_of(*step.cell_index));
                        });
        const CellTimes times = chosen_times(cell_);
        advice_.fixed_pass_ms = times.fixed_pass.median_ms;
        if (const auto cost = cost_of(times)) advice_.ms = cost->ms;
        errors_.push_back(resampled_errors(advice_.metric, *error, cell_.analysis->blocks, results_.seed));
        for (const StepPlan& step : plan_.steps) {
            if (step.cell_index)
                add_drawn(step, cell_of(*step.cell_index));
            else if (step.id == "best-strength")
                add_best_strength(step);
            else
                add_without_noise(step);
        }
        compare();
        sort();
        return std::move(advice_);
    }

  private:
    const CellRecord& cell_of(std::size_t index) const {
        const CellRecord* cell = find_row(results_.cells, ids_[index]);
        if (cell == nullptr) throw internal_error("advice names a cell that is not there", ids_[index]);
        return *cell;
    }

    /// Whether a step's cell has processor time, or was not timed.
    bool has_times_alike(const CellRecord& cell) const {
        return cell.ao.runs_ms.empty() || has_processor_time(times_of(cell, view_));
    }

    CellTimes chosen_times(const CellRecord& cell) const {
        const CellTimes times = times_of(cell, view_);
        return by_processor_ ? on_processor(times) : times;
    }

    void skip(const StepPlan& step, std::string reason) {
        advice_.skipped.push_back({step.id, std::move(reason)});
    }

    StepRecord& add(const StepPlan& step, std::string what, const BlockErrors& blocks, double error) {
        StepRecord& record = advice_.steps.emplace_back();
        record.id = step.id;
        record.what = std::move(what);
        record.error = error;
        compared_.push_back(advice_.steps.size() - 1);
        errors_.push_back(resampled_errors(advice_.metric, error, blocks, results_.seed));
        return record;
    }

    void add_drawn(const StepPlan& step, const CellRecord& changed) {
        const std::optional<double> error = ranked_value(changed, advice_.metric);
        const BlockErrors& before = cell_.analysis->blocks;
        if (!error || !changed.analysis || changed.analysis->blocks.counts != before.counts) {
            StepRecord& failed = advice_.steps.emplace_back();
            failed.id = step.id;
            failed.what = step.what;
            failed.reason = changed.error.empty() ? "other pixels are valid" : changed.error;
            return;
        }
        const BlockErrors& after = changed.analysis->blocks;
        if (after.squared_sums == before.squared_sums && after.absolute_sums == before.absolute_sums) {
            skip(step, fmt::format("it changes no pixel ({})", step.what));
            return;
        }
        StepRecord& record = add(step, step.what, after, *error);
        if (changed.fetches_per_pixel && cell_.fetches_per_pixel)
            record.fetches = *changed.fetches_per_pixel - *cell_.fetches_per_pixel;
        add_cost(record, changed);
    }

    void add_cost(StepRecord& record, const CellRecord& changed) const {
        const CellTimes times = chosen_times(cell_), changed_times = chosen_times(changed);
        const auto before = cost_of(times), after = cost_of(changed_times);
        const std::optional<double> fixed_ms = times.fixed_pass.median_ms;
        if (!before || !after || !fixed_ms || !changed_times.fixed_pass.median_ms) {
            record.reason = "it was not timed";
            return;
        }
        const Cost more = less(scaled(*after, *fixed_ms / *changed_times.fixed_pass.median_ms), *before);
        record.ms = more.ms;
        record.ms_interval = more.interval;
    }

    void add_best_strength(const StepPlan& step) {
        const BestFit& fit = cell_.analysis->fit;
        BlockErrors blocks = cell_.analysis->blocks;
        blocks.squared_sums = fit.squared_sums;
        StepRecord& record =
            add(step, fmt::format("strength {:.2f}, exponent {:.2f}", fit.strength, fit.exponent), blocks,
                value_by_sums(advice_.metric, blocks));
        record.fetches = 0;
        record.reason = "a multiplication and a power a pixel, which were not timed";
    }

    void add_without_noise(const StepPlan& step) {
        if (!cell_.repeats || cell_.repeats->variance.size() != cell_.analysis->blocks.squared_sums.size()) {
            skip(step, "it was not drawn with other seeds");
            return;
        }
        const std::vector<double>& variance = cell_.repeats->variance;
        if (sum_of(variance) == 0) {
            skip(step, "its picture is the same for every seed");
            return;
        }
        BlockErrors blocks = cell_.analysis->blocks;
        for (std::size_t i = 0; i < variance.size(); ++i) blocks.squared_sums[i] -= variance[i];
        StepRecord& record = add(step, fmt::format("over {} seeds", Repeats::kSeeds), blocks,
                                 value_by_sums(advice_.metric, blocks));
        record.fetches = 0;
        record.reason = "it takes other frames, which were not timed";
    }

    void compare() {
        std::vector<MeasurePair> pairs;
        for (std::size_t i = 1; i < errors_.size(); ++i) pairs.emplace_back(i, 0);
        const auto intervals = simultaneous_intervals(errors_, pairs);
        for (std::size_t i = 0; i < compared_.size(); ++i) {
            StepRecord& step = advice_.steps[compared_[i]];
            step.change = intervals[i];
            step.verdict = !step.change || step.change->holds_zero() ? StepRecord::kTie
                           : step.change->high < 0                   ? StepRecord::kCloser
                                                                     : StepRecord::kFarther;
        }
    }

    /// Where a step stands: its group, then what decides within it, the larger the better.
    std::pair<int, double> place(const StepRecord& step) const {
        const double bought = step.bought(advice_.error).value_or(0);
        if (step.verdict == StepRecord::kFailed) return {5, 0};
        if (step.verdict == StepRecord::kFarther) return {4, bought};
        if (step.verdict == StepRecord::kTie) return {3, bought};
        if (!step.ms) return {2, bought};
        return *step.ms > 0 ? std::pair(1, bought / *step.ms) : std::pair(0, bought);
    }

    void sort() {
        std::ranges::stable_sort(advice_.steps, [&](const StepRecord& a, const StepRecord& b) {
            const auto [group_a, worth_a] = place(a);
            const auto [group_b, worth_b] = place(b);
            return group_a != group_b ? group_a < group_b : worth_a > worth_b;
        });
    }

    const AdvicePlan& plan_;
    std::span<const std::string> ids_;
    const Results& results_;
    const CellRecord& cell_;
    const ViewRecord& view_;
    AdviceRecord advice_;
    bool by_processor_ = false;          ///< costs are processor time
    std::vector<Resampled> errors_;      ///< the cell's, then those of the steps in `compared_`
    std::vector<std::size_t> compared_;  ///< indices of steps
};

}  // namespace

AdviceRecord judge_advice(const AdvicePlan& plan, std::span<const std::string> ids, const Results& results) {
    return StepsOfOne(plan, ids, results).judged();
}

}  // namespace aoscore
