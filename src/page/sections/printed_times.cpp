#include "page/sections/printed_times.h"

#include "metrics/intervals/median_interval.h"
#include "page/document/number_text.h"
#include "results/layer_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

/// A setting with the times that its source prints, and this run's processor time of the same passes.
struct PrintedRow {
    const SweepRow* measured;
    std::optional<double> ao_ms, layers_ms;
    std::optional<double> our_ao_ms, our_layers_ms;
};

/// The definition of the view of the sweep's points from `point` on: views come one after the other, with as
/// many points each.
const json& view_definition(const SweepRecord& sweep, const SweepPointRecord& point) {
    const json& views = sweep.definition.at("views");
    const auto index = static_cast<std::size_t>(&point - sweep.points.data());
    return views.at(index * views.size() / sweep.points.size());
}

bool is_at(const SweepPointRecord& point, const json& values) {
    for (const auto& [id, value] : values.items()) {
        const auto found = point.at.find(id);
        if (found == point.at.end() || json(found->second) != value) return false;
    }
    return true;
}

std::optional<double> number_of(const json& row, const char* key) {
    const auto found = row.find(key);
    return found == row.end() ? std::nullopt : std::optional(found->get<double>());
}

std::optional<double> without_layers(const CellRecord& cell) {
    std::vector<double> runs_ms = runs_without_layers_ms(cell);
    return runs_ms.empty() ? std::nullopt : std::optional(median(std::move(runs_ms)));
}

std::vector<PrintedRow> printed_rows(const SweepRecord& sweep, const std::vector<const SweepRow*>& rows) {
    std::vector<PrintedRow> list;
    const json& definition = view_definition(sweep, *rows.front()->point);
    for (const json& printed : definition.value("printed", json::array())) {
        const auto found = std::ranges::find_if(
            rows, [&](const SweepRow* row) { return is_at(*row->point, printed.at("at")); });
        if (found == rows.end() || !(*found)->cell->error.empty()) continue;
        list.push_back({*found, number_of(printed, "ao_ms"), number_of(printed, "layers_ms"),
                        without_layers(*(*found)->cell), (*found)->cell->layers_processor.median_ms});
    }
    return list;
}

/// The ratio to the first row that has such a time.
std::string part_of_first(const std::vector<PrintedRow>& rows, const PrintedRow& row,
                          std::optional<double> PrintedRow::*time) {
    const auto first = std::ranges::find_if(rows, [&](const PrintedRow& r) { return (r.*time).has_value(); });
    return first == rows.end() ? kNoNumber : fixed_text(ratio(row.*time, (*first).*time), 2);
}

}  // namespace

json printed_times(const SweepRecord& sweep, const std::vector<const SweepRow*>& rows) {
    json model = {{"rows", json::array()}};
    if (!sweep.definition.is_object() || rows.empty()) return model;
    const std::vector<PrintedRow> printed = printed_rows(sweep, rows);
    for (const PrintedRow& row : printed) {
        model["rows"].push_back(
            {{"method", row.measured->cell->method_label},
             {"at", point_text(*row.measured->point)},
             {"ao_ms", fixed_text(row.ao_ms, 2)},
             {"ao", part_of_first(printed, row, &PrintedRow::ao_ms)},
             {"our_ao", part_of_first(printed, row, &PrintedRow::our_ao_ms)},
             {"layers_ms", fixed_text(row.layers_ms, 2)},
             {"layers", part_of_first(printed, row, &PrintedRow::layers_ms)},
             {"our_layers", part_of_first(printed, row, &PrintedRow::our_layers_ms)},
             {"error", fixed_text(row.measured->fitted_error, 4)},
             {"found", fixed_text(row.measured->found_of_layers, 2)},
             {"found_of_truth", fixed_text(row.measured->found_of_truth, 2)},
             {"noise", fixed_text(row.measured->noise, 4)}});
    }
    return model;
}

}  // namespace aoscore
