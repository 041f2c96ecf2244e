#include "results/sweep_rows.h"

#include "core/error.h"
#include "core/known_names.h"
#include "metrics/analysis/repeat_values.h"
#include "metrics/intervals/median_interval.h"
#include "metrics/intervals/over_views.h"
#include "metrics/pareto.h"
#include "metrics/roles.h"
#include "results/comparable_views.h"
#include "results/ranked_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace aoscore {
namespace {

template <class Record, class Member>
const Record& named(const std::vector<Record>& records, const std::string& id, Member member) {
    if (const Record* record = find_row(records, id, member)) return *record;
    throw file_error("names " + id + ", which it lacks", "results.json: sweeps");
}

void add_costs(SweepRow& row, const SweepRecord& sweep) {
    const CellRecord& cell = *row.cell;
    row.fetches = cell.fetches_per_pixel;
    row.frame = cell.frame;
    if (cell.ao.runs_ms.empty()) return;
    std::vector<double> runs = cell.ao.runs_ms;
    for (std::size_t i = 0; i < runs.size() && i < cell.filter_pass.runs_ms.size(); ++i)
        runs[i] += cell.filter_pass.runs_ms[i];
    row.cost_ms = median(runs);
    if (const auto interval = median_interval(std::move(runs), sweep.timing_confidence)) {
        row.cost_low_ms = interval->low;
        row.cost_high_ms = interval->high;
    }
    if (cell.fixed_pass.median_ms.value_or(0) > 0)
        row.relative_cost = *row.cost_ms / *cell.fixed_pass.median_ms;
    if (sweep.budget_ms) row.within_budget = *row.cost_ms <= *sweep.budget_ms;
}

void mark_front(std::vector<SweepRow>& rows, const std::vector<std::size_t>& indices) {
    std::vector<CostAndError> points;
    for (const std::size_t i : indices) {
        // A bound is not for use, and so excludes nothing from the front.
        const bool bound = rows[i].cell->role == kBoundRole;
        points.push_back(bound ? CostAndError{} : CostAndError{rows[i].cost_ms, rows[i].error});
    }
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t k = 0; k < indices.size(); ++k) rows[indices[k]].on_front = front[k];
}

void add_findings(SweepRow& row) {
    const CellRecord& cell = *row.cell;
    if (cell.analysis) row.beyond_layer = cell.analysis->found_beyond_layer;
    if (!cell.repeats) return;
    row.found_of_layers = found_share(cell.repeats->of_layers);
    row.found_of_truth = found_share(cell.repeats->of_truth);
    const std::optional<double> noise = noise_over_seeds(*cell.repeats);
    if (noise && cell.repeats->of_truth) row.noise = *noise * cell.repeats->of_truth->strength;
}

using Number = std::optional<double> SweepRow::*;

/// The value over the rows' views; empty where one of the rows lacks it.
template <class OverViews>
std::optional<double> combined(const std::vector<const SweepRow*>& rows, Number number, OverViews over) {
    std::vector<double> values;
    for (const SweepRow* row : rows) {
        const std::optional<double> value = row->*number;
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return over(values);
}

/// The frame of the passes' mean times; empty where one of the rows has none.
std::optional<FrameRecord> mean_frame(const std::vector<const SweepRow*>& rows) {
    FrameRecord sum;
    for (const SweepRow* row : rows) {
        if (!row->frame) return std::nullopt;
        sum.geometry_ms += row->frame->geometry_ms;
        sum.lighting_ms += row->frame->lighting_ms;
        sum.ao_ms += row->frame->ao_ms;
        sum.filter_ms += row->frame->filter_ms;
    }
    const auto count = static_cast<double>(rows.size());
    return frame_of(sum.geometry_ms / count, sum.lighting_ms / count, sum.ao_ms / count,
                    sum.filter_ms / count);
}

SweepRow over_views_of(const std::vector<const SweepRow*>& rows) {
    SweepRow all;
    all.point = rows.front()->point;
    all.cell = rows.front()->cell;
    for (const Number cost : {&SweepRow::cost_ms, &SweepRow::cost_low_ms, &SweepRow::cost_high_ms,
                              &SweepRow::relative_cost, &SweepRow::fetches})
        all.*cost = combined(rows, cost, over_views::mean);
    all.frame = mean_frame(rows);
    const auto as = [](const char* metric) {
        return [metric](std::span<const double> values) { return measure_over_views(metric, values); };
    };
    for (const Number error : {&SweepRow::error, &SweepRow::fitted_error, &SweepRow::unfiltered_error})
        all.*error = combined(rows, error, as(kRankingMetric));
    all.noisy_error = combined(rows, &SweepRow::noisy_error, as(kNoisyRankingMetric));
    all.bias = combined(rows, &SweepRow::bias, as(kBiasMetric));
    if (std::ranges::all_of(rows, [](const SweepRow* row) { return row->within_budget.has_value(); }))
        all.within_budget =
            std::ranges::all_of(rows, [](const SweepRow* row) { return *row->within_budget; });
    return all;
}

}  // namespace

std::vector<SweepRow> sweep_rows(const Results& results, const SweepRecord& sweep) {
    std::vector<SweepRow> rows;
    std::map<const ViewRecord*, std::vector<std::size_t>> by_view;
    for (const SweepPointRecord& point : sweep.points) {
        SweepRow row;
        row.point = &point;
        row.cell = &named(results.cells, point.cell_id, &CellRecord::id);
        row.view = &named(results.views, row.cell->view_key, &ViewRecord::key);
        if (row.cell->error.empty()) {
            add_costs(row, sweep);
            row.error = value_of(row.cell->ranked, kRankingMetric);
            row.noisy_error = value_of(row.cell->ranked, kNoisyRankingMetric);
            if (row.cell->analysis) row.fitted_error = row.cell->analysis->fit.rmse_debiased;
            row.unfiltered_error = value_of(row.cell->raw, kRankingMetric);
            row.bias = value_of(row.cell->ranked, kBiasMetric);
            add_findings(row);
        }
        by_view[row.view].push_back(rows.size());
        rows.push_back(row);
    }
    for (const auto& [view, indices] : by_view) mark_front(rows, indices);
    return rows;
}

std::vector<SweepRowsOverViews> rows_over_views(const std::vector<SweepRow>& rows) {
    std::vector<const ViewRecord*> views;
    for (const SweepRow& row : rows) {
        if (std::ranges::find(views, row.view) == views.end()) views.push_back(row.view);
    }
    std::vector<SweepRowsOverViews> all;
    for (const auto& group : comparable_views(views)) {
        if (group.size() < 2) continue;
        std::map<ParameterValues, std::vector<const SweepRow*>> by_setting;
        std::vector<const std::vector<const SweepRow*>*> in_order;
        for (const SweepRow& row : rows) {
            if (std::ranges::find(group, row.view) == group.end()) continue;
            auto& same = by_setting[row.point->at];
            if (same.empty()) in_order.push_back(&same);
            same.push_back(&row);
        }
        SweepRowsOverViews combined{group, {}};
        for (const auto* same : in_order) {
            const bool worked =
                std::ranges::all_of(*same, [](const SweepRow* row) { return row->cell->error.empty(); });
            if (same->size() == group.size() && worked) combined.rows.push_back(over_views_of(*same));
        }
        std::vector<std::size_t> indices(combined.rows.size());
        std::iota(indices.begin(), indices.end(), std::size_t{0});
        mark_front(combined.rows, indices);
        if (!combined.rows.empty()) all.push_back(std::move(combined));
    }
    return all;
}

std::string point_text(const SweepPointRecord& point) {
    std::vector<std::string> parts;
    for (const auto& [axis, value] : point.at) {
        if (axis == "method") continue;
        parts.push_back(axis + " " + value.text());
    }
    return parts.empty() ? "as it is" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace aoscore
