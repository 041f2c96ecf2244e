#include "results/export/export_table.h"

#include "metrics/signal_metric.h"
#include "results/layer_times.h"
#include "results/lengths_text.h"
#include "results/light_modes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>
#include <utility>

namespace aoscore {
namespace {

/// The column that readers are shown where a method reads several layers, as the page does.
constexpr std::string_view kBeyondLayer = "found_beyond_layer";

struct Part {
    ExportColumn column;
    std::function<std::optional<double>(const MetricMap&, const ErrorAnalysis*)> value;
};

std::optional<double> bound(const ErrorAnalysis* analysis, const std::string& id, double Interval::*end) {
    if (analysis == nullptr) return std::nullopt;
    const auto found = analysis->intervals.find(id);
    return found == analysis->intervals.end() ? std::nullopt : std::optional(found->second.*end);
}

std::vector<Part> measure_parts() {
    std::vector<Part> parts;
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        const std::string unit = metric.unit.empty() ? "" : " (" + std::string(metric.unit) + ")";
        parts.push_back({{id, std::string(metric.label) + unit, metric.decimals, metric.brief},
                         [id](const MetricMap& map, const ErrorAnalysis*) {
                             const auto found = map.find(id);
                             return found == map.end() ? std::nullopt : found->second.value;
                         }});
    }
    constexpr std::array ends{std::pair("_low", &Interval::low), std::pair("_high", &Interval::high)};
    for (const std::string& id : bootstrap_measures()) {
        for (const auto& [suffix, end] : ends) {
            parts.push_back(
                {{id + suffix, "", 4, false},
                 [id, end](const MetricMap&, const ErrorAnalysis* a) { return bound(a, id, end); }});
        }
    }
    const auto add = [&](std::string_view key, std::string_view label, bool brief,
                         std::function<std::optional<double>(const ErrorAnalysis&)> value) {
        parts.push_back({{std::string(key), std::string(label), 4, brief},
                         [value](const MetricMap&, const ErrorAnalysis* a) {
                             return a == nullptr ? std::nullopt : value(*a);
                         }});
    };
    for (const MaskArea& area : mask_areas()) {
        add(area.id, area.label, true, area.value);
        const std::string mean_id(area.mean_id);
        add(mean_id, "", false, area.mean);
        for (const auto& [suffix, end] : ends)
            add(mean_id + suffix, "", false,
                [mean_id, end](const ErrorAnalysis& a) { return bound(&a, mean_id, end); });
    }
    add("fit_strength", "", false, [](const ErrorAnalysis& a) { return a.fit.strength; });
    add("fit_exponent", "", false, [](const ErrorAnalysis& a) { return a.fit.exponent; });
    add("fit_rmse", "", false, [](const ErrorAnalysis& a) { return a.fit.rmse; });
    add(kBeyondLayer, "Beyond one layer", false, [](const ErrorAnalysis& a) { return a.found_beyond_layer; });
    return parts;
}

/// The metrics of those signals beside visibility that some cell has.
std::vector<const SignalMetric*> signal_columns(const Results& results) {
    std::vector<const SignalMetric*> columns;
    for (const SignalMetric& metric : signal_metrics()) {
        const std::string id(metric.signal);
        const bool some = std::ranges::any_of(
            results.cells, [&](const CellRecord& cell) { return cell.signals.contains(id); });
        if (some) columns.push_back(&metric);
    }
    return columns;
}

std::optional<double> value_of(const CellRecord& cell, const SignalMetric& metric) {
    const auto of_signal = cell.signals.find(std::string(metric.signal));
    if (of_signal == cell.signals.end()) return std::nullopt;
    const auto found = of_signal->second.find(std::string(metric.id));
    return found == of_signal->second.end() ? std::nullopt : found->second.value;
}

/// An error of light that some cell has, or an end of its interval.
struct LightColumn {
    std::string measure;
    ExportColumn column;
    std::optional<double> (*value)(const MeasureRecord&);
};

std::vector<LightColumn> light_columns(const Results& results) {
    std::vector<LightColumn> columns;
    const auto add = [&](const std::string& measure, const std::string& label) {
        const bool some = std::ranges::any_of(
            results.cells, [&](const CellRecord& cell) { return cell.light.contains(measure); });
        if (!some) return;
        const std::string id = std::string(kLightPrefix) + measure;
        columns.push_back(
            {measure, {id, label, 4, true}, [](const MeasureRecord& m) { return std::optional(m.value); }});
        columns.push_back({measure, {id + "_low", "", 4, false}, [](const MeasureRecord& m) {
                               return m.interval ? std::optional(m.interval->low) : std::nullopt;
                           }});
        columns.push_back({measure, {id + "_high", "", 4, false}, [](const MeasureRecord& m) {
                               return m.interval ? std::optional(m.interval->high) : std::nullopt;
                           }});
    };
    for (const LightMode& mode : light_modes()) {
        add(mode.relative_error(), fmt::format("Light, {}, relative RMSE", mode.label));
        add(mode.bias(), fmt::format("Light, {}, bias", mode.label));
    }
    return columns;
}

std::optional<double> value_of(const CellRecord& cell, const LightColumn& column) {
    const auto found = cell.light.find(column.measure);
    return found == cell.light.end() ? std::nullopt : column.value(found->second);
}

/// A note for each view: its radius, and the lengths that every method has there.
std::vector<std::string> radius_notes(const Results& results) {
    std::vector<std::string> notes;
    for (const ViewRecord& view : results.views) {
        std::vector<std::string> drawn;
        for (const CellRecord& cell : results.cells) {
            const std::string lengths = lengths_text(cell);
            if (cell.view_key != view.key || lengths.empty()) continue;
            drawn.push_back(fmt::format("{} {}: {}", shown_name(cell), cell.preset, lengths));
        }
        notes.push_back(fmt::format("{}: {}.", view.key, radius_text(view)));
        if (!drawn.empty()) notes.back() += fmt::format(" Lengths: {}.", fmt::join(drawn, "; "));
    }
    return notes;
}

/// The cell's place in the ranking of its view; null where it failed.
const PlaceRecord* place_of(const Results& results, const CellRecord& cell) {
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() != 1) continue;
        for (const PlaceRecord& place : ranking.places) {
            if (place.cell_ids.front() == cell.id) return &place;
        }
    }
    return nullptr;
}

}  // namespace

void add_measures(ExportTable& table) {
    for (Part& part : measure_parts()) table.columns.push_back(std::move(part.column));
}

std::vector<std::optional<double>> measures_of(const MetricMap& metrics,
                                               const std::optional<ErrorAnalysis>& analysis) {
    std::vector<std::optional<double>> numbers;
    for (const Part& part : measure_parts())
        numbers.push_back(part.value(metrics, analysis ? &*analysis : nullptr));
    return numbers;
}

ExportTable export_table(const Results& results,
                         const std::map<std::string, std::vector<std::string>>& failures) {
    ExportTable table;
    table.title = results.command;
    table.document = to_json(results);
    table.name_columns = {"view", "rank", "method", "role", "preset", "setting", "filter"};
    add_measures(table);
    if (std::ranges::any_of(results.cells, reads_layers))
        std::ranges::find(table.columns, kBeyondLayer, &ExportColumn::key)->brief = true;
    const std::vector<const SignalMetric*> of_signals = signal_columns(results);
    for (const SignalMetric* metric : of_signals) {
        table.columns.push_back({std::string(metric->id), fmt::format("{} ({})", metric->label, metric->unit),
                                 metric->decimals, true});
    }
    const std::vector<LightColumn> of_light = light_columns(results);
    for (const LightColumn& column : of_light) table.columns.push_back(column.column);
    table.columns.push_back({"rank_best", "", 0, false});
    table.columns.push_back({"rank_worst", "", 0, false});
    table.columns.push_back({"fetches_per_pixel", "Fetches", 1});
    table.columns.push_back({"ao_ms", "AO (ms)", 1});
    table.columns.push_back({"filter_ms", "Filter (ms)", 1});
    table.columns.push_back({"frame_ms", "Frame (ms)", 1});
    table.columns.push_back({"radius_m", "", 4, false});
    table.columns.push_back({"radius_px", "", 1, false});
    table.text_columns = {"radius_rule", "lengths"};
    table.notes = radius_notes(results);
    for (const CellRecord& cell : results.cells) {
        const PlaceRecord* place = place_of(results, cell);
        std::optional<double> best, worst;
        if (place != nullptr && place->rank)
            std::tie(best, worst) = std::pair(place->rank->best, place->rank->worst);
        ExportRow row{
            cell.id.starts_with(cell.view_key + "/") ? cell.id.substr(cell.view_key.size() + 1) : cell.id,
            {cell.view_key, place != nullptr ? rank_text(*place) : "", cell.method, cell.role, cell.preset,
             cell.setting, cell.filter},
            measures_of(cell.ranked, cell.analysis),
            {},
            cell.error,
            {}};
        const auto view = std::ranges::find(results.views, cell.view_key, &ViewRecord::key);
        const bool known = view != results.views.end();
        for (const SignalMetric* metric : of_signals) row.numbers.push_back(value_of(cell, *metric));
        for (const LightColumn& column : of_light) row.numbers.push_back(value_of(cell, column));
        for (const auto& number :
             {best, worst, cell.fetches_per_pixel, cell.ao.median_ms, cell.filter_pass.median_ms,
              cell.frame_ms, known ? std::optional(view->radius_m) : std::nullopt,
              known ? std::optional(view->radius_px_median) : std::nullopt}) {
            row.numbers.push_back(number);
        }
        row.texts = {known ? view->radius_rule : "", lengths_text(cell)};
        if (const auto found = failures.find(cell.id); found != failures.end()) row.failures = found->second;
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace aoscore
