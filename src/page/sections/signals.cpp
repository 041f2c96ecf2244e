#include "core/counted.h"
#include "core/signal.h"
#include "metrics/signal_metric.h"
#include "page/document/number_text.h"
#include "page/pictures/signal_picture.h"
#include "page/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

/// A method's name for its pictures and rows.
std::string name_of(const CellRecord& cell) {
    return fmt::format("{}, {}", shown_name(cell), cell.preset);
}

/// The cells of a view that have this signal, in the order of its first metric.
std::vector<const CellRecord*> cells_with(const Results& results, const ViewRecord& view,
                                          const std::string& id, const std::string& first_metric) {
    std::vector<const CellRecord*> cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key && cell.signals.contains(id)) cells.push_back(&cell);
    }
    std::ranges::stable_sort(cells, {}, [&](const CellRecord* cell) {
        const auto& value = cell->signals.at(id).at(first_metric).value;
        return std::pair(!value.has_value(), value.value_or(0));
    });
    return cells;
}

json numbers_of(const CellRecord& cell, const std::vector<const SignalMetric*>& columns) {
    json numbers = json::array();
    for (const SignalMetric* column : columns) {
        const MeasuredMetric& metric =
            cell.signals.at(std::string(column->signal)).at(std::string(column->id));
        numbers.push_back({{"text", fixed_text(metric.value, column->decimals)},
                           {"sort", metric.value ? fmt::format("{}", *metric.value) : ""},
                           {"note", metric.note}});
    }
    return numbers;
}

json table_of(const PageSource& source, const ViewRecord& view, const SignalRecord& record) {
    const Signal& row = signal(record.id);
    std::vector<const SignalMetric*> columns;
    json heads = json::array();
    for (const SignalMetric& metric : signal_metrics()) {
        if (metric.signal != record.id) continue;
        columns.push_back(&metric);
        heads.push_back({{"label", std::string(metric.label)},
                         {"unit", std::string(metric.unit)},
                         {"meaning", std::string(metric.meaning)}});
    }
    json rows = json::array(), pictures = json::array();
    const auto of_truth = source.pictures.views.find(view.key);
    if (of_truth != source.pictures.views.end())
        pictures.push_back(
            {{"name", "Truth"}, {"has_error", false}, {"uri", of_truth->second.signals.at(record.id).uri}});
    for (const CellRecord* cell : cells_with(source.results, view, record.id, std::string(columns[0]->id))) {
        rows.push_back(
            {{"method", name_of(*cell)}, {"cell", cell->id}, {"numbers", numbers_of(*cell, columns)}});
        const auto shown = source.pictures.cells.find(cell->id);
        if (shown == source.pictures.cells.end() || !shown->second.signals.contains(record.id)) continue;
        const auto error = shown->second.signal_errors.find(record.id);
        const bool has_error = error != shown->second.signal_errors.end();
        pictures.push_back({{"name", name_of(*cell)},
                            {"uri", shown->second.signals.at(record.id).uri},
                            {"has_error", has_error},
                            {"error", has_error ? error->second.uri : ""}});
    }
    const SignalErrorRange range = signal_error_range(row);
    const auto degrees = [](double value) { return short_text(value) + "°"; };
    return {{"label", std::string(row.label)},
            {"meaning", std::string(row.meaning)},
            {"noise", fixed_text(record.mean_standard_error_deg, 2)},
            {"known", count_text(record.known_pixels)},
            {"valid", count_text(view.valid_pixels)},
            {"is_direction", row.channels.size() == 3},
            {"low", degrees(range.low_deg)},
            {"middle", degrees((range.low_deg + range.high_deg) / 2)},
            {"high", degrees(range.high_deg)},
            {"heads", std::move(heads)},
            {"rows", std::move(rows)},
            {"pictures", std::move(pictures)}};
}

/// A label within a sentence.
std::string in_text(std::string_view label) {
    std::string text(label);
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// Names the method that is closest in the first signal of the first view that has one and knows it.
std::string signals_in_short(const Results& results) {
    bool is_unknown = false;
    for (const ViewRecord& view : results.views) {
        for (const SignalRecord& record : view.signals) {
            const auto metric = std::ranges::find(signal_metrics(), record.id, &SignalMetric::signal);
            const auto cells = cells_with(results, view, record.id, std::string(metric->id));
            if (cells.empty()) continue;
            const auto& value = cells[0]->signals.at(record.id).at(std::string(metric->id)).value;
            is_unknown = is_unknown || !value;
            if (!value) continue;
            const std::string of = record.known_pixels < view.valid_pixels
                                       ? fmt::format(" over the {:.0f} % of the pixels whose truth is certain",
                                                     100.0 * static_cast<double>(record.known_pixels) /
                                                         static_cast<double>(view.valid_pixels))
                                       : "";
            const std::string number = fixed_text(value, metric->decimals) + std::string(metric->unit) + of;
            if (cells.size() == 1)
                return fmt::format("On {}, {} is the only method that gives the {}: its {} is {}.", view.key,
                                   name_of(*cells[0]), in_text(signal(record.id).label),
                                   in_text(metric->label), number);
            return fmt::format("On {}, {} is closest of {} to the truth’s {}: its {} is {}.", view.key,
                               name_of(*cells[0]), counted(cells.size(), "method", "methods"),
                               in_text(signal(record.id).label), in_text(metric->label), number);
        }
    }
    if (is_unknown) return "The truth has too few rays to know these signals in any pixel.";
    return "No method gives a signal beside visibility.";
}

}  // namespace

json section::signals(const PageSource& source) {
    json views = json::array();
    for (const ViewRecord& view : source.results.views) {
        if (view.signals.empty()) continue;
        json tables = json::array();
        for (const SignalRecord& record : view.signals) tables.push_back(table_of(source, view, record));
        views.push_back({{"key", view.key}, {"tables", std::move(tables)}});
    }
    return {{"views", std::move(views)}, {"in_short", signals_in_short(source.results)}};
}

}  // namespace aoscore
