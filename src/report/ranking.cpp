#include "core/error.h"
#include "report/baseline_table.h"
#include "report/interval_tables.h"
#include "report/number_text.h"
#include "report/ranking_columns.h"
#include "report/section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace aoscore {
namespace {

using nlohmann::json;

/// The columns and how many decimals each has over the whole page.
struct Columns {
    std::vector<RankingColumn> list;
    std::vector<int> decimals;
};

Columns columns_of(const Results& results) {
    Columns columns{ranking_columns(results), {}};
    for (const RankingColumn& column : columns.list) {
        std::vector<std::optional<double>> values;
        for (const CellRecord& cell : results.cells) values.push_back(column.value(cell).value);
        columns.decimals.push_back(column.decimals.value_or(column_decimals(values)));
    }
    return columns;
}

/// Where a value and its interval lie between 0 and the table's largest, for a bar under the number.
json bar_model(const PlaceRecord& place, double largest) {
    const auto part = [&](double value) {
        return fmt::format("{:.2f}%", largest > 0 ? std::clamp(value / largest, 0.0, 1.0) * 100 : 0.0);
    };
    return {{"low", part(place.interval.low)},
            {"high", part(place.interval.high)},
            {"at", part(place.value)},
            {"text", fmt::format("95 % between {} and {}", fixed_text(place.interval.low, 4),
                                 fixed_text(place.interval.high, 4))}};
}

double largest_of(const RankingRecord& ranking) {
    double largest = 0;
    for (const PlaceRecord& place : ranking.places) largest = std::max(largest, place.interval.high);
    return largest;
}

/// "2", and with whom it is tied.
json rank_model(const RankingRecord& ranking, const PlaceRecord& place) {
    std::vector<std::string> others;
    for (const std::size_t other : place.ties) others.push_back(ranking.places.at(other).method_label);
    return {{"rank", std::to_string(place.rank)},
            {"tied", !others.empty()},
            {"ties", others.empty() ? "" : fmt::format("tied with {}", fmt::join(others, ", "))}};
}

std::string metric_text(const std::string& metric) {
    return metric == "rmse_debiased" ? "debiased RMSE" : "RMSE";
}

json row_model(const Columns& columns, const CellRecord& cell) {
    json row = {{"method", shown_name(cell)},
                {"id", cell.method},
                {"filter", cell.filter},
                {"error", cell.error},
                {"failed", !cell.error.empty()},
                {"cell", cell.id},
                {"rank", {{"rank", kNoNumber}, {"tied", false}, {"ties", ""}}},
                {"sort", ""},
                {"span", std::to_string(columns.list.size())},
                {"numbers", json::array()}};
    if (!cell.error.empty()) return row;
    for (std::size_t i = 0; i < columns.list.size(); ++i) {
        const MeasuredMetric measured = columns.list[i].value(cell);
        const bool known = measured.value && std::isfinite(*measured.value);
        row["numbers"].push_back({{"text", fixed_text(measured.value, columns.decimals[i])},
                                  {"sort", known ? fmt::format("{}", *measured.value) : std::string()},
                                  {"note", measured.note},
                                  {"ranks", false},
                                  {"bars", json::array()}});
    }
    return row;
}

json place_row(const Columns& columns, const Results& results, const RankingRecord& ranking,
               const PlaceRecord& place) {
    const CellRecord* cell = find_cell(results, place.cell_ids.front());
    if (cell == nullptr)
        throw file_error("ranks a cell that it lacks, " + place.cell_ids.front(), "results.json");
    json row = row_model(columns, *cell);
    row["rank"] = rank_model(ranking, place);
    row["sort"] = std::to_string(place.rank);
    for (std::size_t i = 0; i < columns.list.size() && !row["failed"]; ++i) {
        if (columns.list[i].id != ranking.metric) continue;
        row["numbers"][i]["ranks"] = true;
        row["numbers"][i]["bars"].push_back(bar_model(place, largest_of(ranking)));
    }
    return row;
}

json view_table(const Columns& columns, const Results& results, const RankingRecord& ranking) {
    const ViewRecord& view = find_view(results, ranking.view_keys.front());
    json rows = json::array();
    for (const PlaceRecord& place : ranking.places)
        rows.push_back(place_row(columns, results, ranking, place));
    const double floor = view.truths.empty() ? 0.0 : view.truths.front().noise_floor_rmse;
    return {{"key", view.key},
            {"preset", ranking.preset},
            {"radius", short_text(view.radius_m)},
            {"radius_px", fixed_text(view.radius_px_median, 1)},
            {"floor", fixed_text(floor, 4)},
            {"metric", metric_text(ranking.metric)},
            {"rows", std::move(rows)}};
}

/// Cells that no ranking holds: what failed.
json failed_rows(const Columns& columns, const Results& results) {
    json rows = json::array();
    for (const CellRecord& cell : results.cells) {
        if (cell.error.empty()) continue;
        json row = row_model(columns, cell);
        row["preset"] = cell.preset;
        row["view"] = cell.view_key;
        rows.push_back(std::move(row));
    }
    return rows;
}

json overall_table(const RankingRecord& ranking) {
    json rows = json::array();
    for (const PlaceRecord& place : ranking.places) {
        const bool first = rows.empty();
        rows.push_back({{"method", place.method_label},
                        {"filter", place.filter},
                        {"rank", rank_model(ranking, place)},
                        {"value", fixed_text(place.value, 4)},
                        {"sort", fmt::format("{}", place.value)},
                        {"bars", json::array({bar_model(place, largest_of(ranking))})},
                        {"behind", first ? kNoNumber
                                         : fmt::format("{} to {}", fixed_text(place.behind_best.low, 4),
                                                       fixed_text(place.behind_best.high, 4))},
                        {"behind_sort", first ? "" : fmt::format("{}", place.behind_best.low)}});
    }
    return {{"views", fmt::format("{}", fmt::join(ranking.view_keys, ", "))},
            {"preset", ranking.preset},
            {"metric", metric_text(ranking.metric)},
            {"rows", std::move(rows)}};
}

/// Numbers that are missing although their cells succeeded, with the reason: a dash alone would hide it.
json gaps_of(const std::vector<RankingColumn>& list, const Results& results) {
    std::map<std::pair<std::string, std::string>, std::vector<std::string>> cells_by_gap;
    for (const CellRecord& cell : results.cells) {
        if (!cell.error.empty()) continue;
        for (const RankingColumn& column : list) {
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
    const Columns columns = columns_of(results);
    json heads = json::array();
    for (const RankingColumn& column : columns.list) {
        heads.push_back({{"label", column.label}, {"unit", column.unit}, {"meaning", column.meaning}});
    }
    json model = {{"heads", heads},
                  {"views", json::array()},
                  {"overall", json::array()},
                  {"intervals", interval_tables(results)},
                  {"baselines", baseline_tables(results)},
                  {"failures", failed_rows(columns, results)},
                  {"gaps", gaps_of(columns.list, results)}};
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() == 1) {
            model["views"].push_back(view_table(columns, results, ranking));
        } else {
            model["overall"].push_back(overall_table(ranking));
        }
    }
    model["has_failures"] = !model["failures"].empty();
    model["has_gaps"] = !model["gaps"].empty();
    return model;
}

}  // namespace aoscore
