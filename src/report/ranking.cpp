#include "metrics/metric.h"
#include "report/closeness.h"
#include "report/number_text.h"
#include "report/section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace aoscore {
namespace {

using nlohmann::json;
using Cells = std::vector<const CellRecord*>;

/// One column of numbers: its head, how wide its digits run, and where a cell's number comes from.
struct Column {
    std::string id;  ///< of the metric; empty for costs and areas
    std::string label, unit, meaning;
    std::function<MeasuredMetric(const CellRecord&)> value;
    std::optional<int> decimals;  ///< empty: as the column's largest number asks
};

MeasuredMetric metric_of(const CellRecord& cell, const std::string& id) {
    const auto found = cell.ranked.find(id);
    return found == cell.ranked.end() ? MeasuredMetric{std::nullopt, "not measured"} : found->second;
}

std::vector<Column> columns(const PageSource& source) {
    std::vector<Column> list;
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        list.push_back({id, std::string(metric.label), std::string(metric.unit), std::string(metric.meaning),
                        [id](const CellRecord& cell) { return metric_of(cell, id); },
                        metric.unit.empty() ? 4 : 2});
    }
    const auto area = [](MaskSummary ErrorAnalysis::*mask) {
        return [mask](const CellRecord& cell) {
            if (!cell.analysis) return MeasuredMetric{std::nullopt, ""};
            return MeasuredMetric{(*cell.analysis.*mask).area * 100, ""};
        };
    };
    const std::string threshold = short_text(source.results.mask_threshold);
    list.push_back({"", "Missing", "%",
                    "Valid pixels brighter than the truth by more than " + threshold + ".",
                    area(&ErrorAnalysis::missing), 2});
    list.push_back({"", "False", "%", "Valid pixels darker than the truth by more than " + threshold + ".",
                    area(&ErrorAnalysis::false_occlusion), 2});
    list.push_back({"", "Fetches", "a pixel",
                    "Texture reads of the AO pass, counted, mean over valid pixels.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.fetches_per_pixel, ""};
                    },
                    1});
    list.push_back({"", "AO", "ms", "Median of the AO pass.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.ao.median_ms, ""};
                    },
                    std::nullopt});
    list.push_back({"", "Filter", "ms", "Median of the filter after it.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.blur.median_ms, ""};
                    },
                    std::nullopt});
    list.push_back({"", "Frame", "ms", "G-buffer, AO pass and filter together.",
                    [](const CellRecord& cell) {
                        return MeasuredMetric{cell.frame_ms, ""};
                    },
                    std::nullopt});
    return list;
}

json number_model(const Column& column, const CellRecord& cell, int decimals, const std::string& ranking) {
    const MeasuredMetric measured = column.value(cell);
    const bool known = measured.value && std::isfinite(*measured.value);
    return {{"text", fixed_text(measured.value, decimals)},
            {"sort", known ? fmt::format("{}", *measured.value) : std::string()},
            {"note", measured.note},
            {"ranks", column.id == ranking}};
}

json row_model(const std::vector<Column>& list, const std::vector<int>& decimals, const CellRecord& cell,
               const std::string& rank, const std::string& ranking) {
    json row = {{"method", cell.method_label},
                {"id", cell.method},
                {"preset", cell.preset},
                {"filter", cell.filter},
                {"error", cell.error},
                {"failed", !cell.error.empty()},
                {"rank", rank},
                {"rank_sort", rank == kNoNumber ? "" : rank},
                {"cell", cell.id},
                {"span", std::to_string(list.size())},
                {"numbers", json::array()}};
    if (!cell.error.empty()) return row;
    for (std::size_t i = 0; i < list.size(); ++i)
        row["numbers"].push_back(number_model(list[i], cell, decimals[i], ranking));
    return row;
}

Cells in_order(const Results& results, const ViewRecord& view, std::string& metric) {
    Cells cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key) cells.push_back(&cell);
    }
    metric = ranking_metric(cells);
    std::stable_sort(cells.begin(), cells.end(), [&](const CellRecord* a, const CellRecord* b) {
        const auto value_a = ranked_value(*a, metric), value_b = ranked_value(*b, metric);
        return value_a && (!value_b || *value_a < *value_b);
    });
    return cells;
}

/// Numbers that are missing although their cells succeeded, with the reason: a dash alone would hide it.
json gaps_of(const std::vector<Column>& list, const Results& results) {
    std::map<std::pair<std::string, std::string>, std::vector<std::string>> cells_by_gap;
    for (const CellRecord& cell : results.cells) {
        if (!cell.error.empty()) continue;
        for (const Column& column : list) {
            const MeasuredMetric measured = column.value(cell);
            if (measured.value || measured.note.empty()) continue;
            cells_by_gap[{column.label, measured.note}].push_back(cell.id);
        }
    }
    json gaps = json::array();
    for (const auto& [gap, cells] : cells_by_gap) {
        const std::string where = cells.size() <= 3 ? fmt::format("{}", fmt::join(cells, ", "))
                                                    : fmt::format("{} cells", cells.size());
        gaps.push_back(fmt::format("{} is missing of {}: {}", gap.first, where, gap.second));
    }
    return gaps;
}

}  // namespace

nlohmann::json section::ranking(const PageSource& source) {
    const Results& results = source.results;
    const std::vector<Column> list = columns(source);
    std::vector<int> decimals;
    json heads = json::array();
    for (const Column& column : list) {
        std::vector<std::optional<double>> values;
        for (const CellRecord& cell : results.cells) values.push_back(column.value(cell).value);
        decimals.push_back(column.decimals.value_or(column_decimals(values)));
        heads.push_back({{"label", column.label}, {"unit", column.unit}, {"meaning", column.meaning}});
    }
    json model = {{"heads", heads}, {"views", json::array()}, {"gaps", gaps_of(list, results)}};
    for (const ViewRecord& view : results.views) {
        std::string metric;
        const Cells cells = in_order(results, view, metric);
        json rows = json::array();
        int rank = 0;
        for (const CellRecord* cell : cells) {
            const bool placed = ranked_value(*cell, metric).has_value();
            rows.push_back(
                row_model(list, decimals, *cell, placed ? std::to_string(++rank) : kNoNumber, metric));
        }
        const double floor = view.truths.empty() ? 0.0 : view.truths.front().noise_floor_rmse;
        model["views"].push_back({{"key", view.key},
                                  {"radius", short_text(view.radius_m)},
                                  {"floor", fixed_text(floor, 4)},
                                  {"metric", metric == "rmse_debiased" ? "debiased RMSE" : "RMSE"},
                                  {"rows", std::move(rows)}});
    }
    model["has_gaps"] = !model["gaps"].empty();
    return model;
}

}  // namespace aoscore
