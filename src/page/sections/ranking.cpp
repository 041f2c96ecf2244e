#include "core/error.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/bootstrap.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/baseline_table.h"
#include "page/sections/interval_tables.h"
#include "page/sections/place_name.h"
#include "page/sections/ranking_columns.h"
#include "page/sections/ranking_sentence.h"
#include "results/ranked_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace aoscore {
namespace {

using nlohmann::json;

/// The columns with the decimals of each, which are the same over the whole page.
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

/// The positions of a value and its interval between 0 and the table's largest, for a bar under the number.
json bar_model(const PlaceRecord& place, double largest) {
    const auto part = [&](double value) {
        return fmt::format("{:.2f}%", largest > 0 ? std::clamp(value / largest, 0.0, 1.0) * 100 : 0.0);
    };
    const Interval span = place.interval.value_or(Interval{place.value, place.value});
    return {{"low", part(span.low)},
            {"high", part(span.high)},
            {"at", part(place.value)},
            {"text", place.interval ? fmt::format("95 % between {} and {}", fixed_text(span.low, 4),
                                                  fixed_text(span.high, 4))
                                    : kNoInterval}};
}

double largest_of(const RankingRecord& ranking) {
    double largest = 0;
    for (const PlaceRecord& place : ranking.places)
        largest = std::max(largest, place.interval ? place.interval->high : place.value);
    return largest;
}

/// The rank, "1–3", with the places that do not differ significantly.
json rank_model(const RankingRecord& ranking, const PlaceRecord& place) {
    std::vector<std::string> others;
    for (const std::size_t other : place.ties)
        others.push_back(place_name(ranking, ranking.places.at(other)));
    const std::string ties =
        others.empty() ? "" : fmt::format("not surely apart from {}", fmt::join(others, ", "));
    return {{"rank", rank_text(place)},
            {"sort", place.rank ? fmt::format("{}", place.rank->best + place.rank->worst / 1e4) : ""},
            {"ties", place.rank ? ties : "a bound, not for use: not ranked"}};
}

json row_model(const Columns& columns, const CellRecord& cell) {
    json row = {{"method", shown_name(cell)},
                {"id", cell.method},
                {"preset", cell.preset},
                {"filter", cell.filter},
                {"error", cell.error},
                {"failed", !cell.error.empty()},
                {"cell", cell.id},
                {"rank", {{"rank", kNoNumber}, {"sort", ""}, {"ties", ""}}},
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
            {"radius", short_text(ranking.radius_m)},
            {"radius_px", fixed_text(view.radius_px_median, 1)},
            {"floor", fixed_text(floor, 4)},
            {"metric", std::string(metric(ranking.metric).in_text)},
            {"rows", std::move(rows)}};
}

/// The rows of cells that failed, which no ranking holds.
json failed_rows(const Columns& columns, const Results& results) {
    json rows = json::array();
    for (const CellRecord& cell : results.cells) {
        if (cell.error.empty()) continue;
        json row = row_model(columns, cell);
        row["view"] = cell.view_key;
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Names the cells that lack some of a ranking's views, and so have no place in it, with the number of
/// missing views.
std::string left_out_text(const Results& results, const RankingRecord& ranking) {
    std::map<std::string, std::size_t> views_of;
    for (const CellRecord& cell : results.cells) {
        const bool here = std::ranges::find(ranking.view_keys, cell.view_key) != ranking.view_keys.end();
        if (here) views_of[fmt::format("{}, {}", shown_name(cell), cell.preset)] += cell.error.empty();
    }
    std::vector<std::string> left_out;
    for (const auto& [name, views] : views_of) {
        if (views < ranking.view_keys.size())
            left_out.push_back(fmt::format("{} ({} of {} views)", name, views, ranking.view_keys.size()));
    }
    if (left_out.empty()) return {};
    return fmt::format("Not scored on every one of these views: {}.", fmt::join(left_out, "; "));
}

json overall_table(const Results& results, const RankingRecord& ranking) {
    json rows = json::array();
    for (const PlaceRecord& place : ranking.places) {
        const auto& behind = place.behind_first;
        rows.push_back({{"method", place.method_label},
                        {"preset", place.preset},
                        {"filter", place.filter},
                        {"rank", rank_model(ranking, place)},
                        {"value", fixed_text(place.value, 4)},
                        {"sort", fmt::format("{}", place.value)},
                        {"bars", json::array({bar_model(place, largest_of(ranking))})},
                        {"behind", behind ? fmt::format("{} to {}", fixed_text(behind->low, 4),
                                                        fixed_text(behind->high, 4))
                                          : kNoNumber},
                        {"behind_sort", behind ? fmt::format("{}", behind->low) : ""}});
    }
    const std::string left_out = left_out_text(results, ranking);
    return {{"views", fmt::format("{}", fmt::join(ranking.view_keys, ", "))},
            {"count", std::to_string(ranking.view_keys.size())},
            {"radius", short_text(ranking.radius_m)},
            {"metric", std::string(metric(ranking.metric).in_text)},
            {"has_left_out", !left_out.empty()},
            {"left_out", left_out},
            {"rows", std::move(rows)}};
}

/// The numbers that are missing although their cells succeeded, with the reason, which a dash alone would
/// hide.
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

/// Names the ends of the widest ranking: over views where there is one, else of the first view.
std::string ranking_in_short(const Results& results) {
    const RankingRecord* widest = nullptr;
    for (const RankingRecord& ranking : results.rankings) {
        if (widest == nullptr || ranking.view_keys.size() > widest->view_keys.size()) widest = &ranking;
    }
    const Places ranked = widest != nullptr ? ranked_places(*widest) : Places();
    if (ranked.empty()) return "Nothing was ranked.";
    const auto end = [&](const PlaceRecord& place) {
        return fmt::format("{} ({}, rank {})", fixed_text(place.value, 4), place_name(*widest, place),
                           rank_text(place));
    };
    const std::string where = widest->view_keys.size() == 1
                                  ? "On " + widest->view_keys.front()
                                  : fmt::format("Over {} views", widest->view_keys.size());
    if (ranked.size() == 1)
        return fmt::format("{} one method was ranked, with a {} of {}.", where,
                           metric(widest->metric).in_text, end(*ranked[0]));
    return fmt::format("{} the {}s of {} methods go from {} to {}.", where, metric(widest->metric).in_text,
                       ranked.size(), end(*ranked.front()), end(*ranked.back()));
}

}  // namespace

nlohmann::json section::ranking(const PageSource& source) {
    const Results& results = source.results;
    const Columns columns = columns_of(results);
    json heads = json::array();
    for (const RankingColumn& column : columns.list) {
        heads.push_back({{"label", column.label},
                         {"unit", column.unit},
                         {"meaning", column.meaning},
                         {"keep", std::to_string(column.keep)}});
    }
    json model = {{"in_short", ranking_in_short(results)},
                  {"heads", heads},
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
            model["overall"].push_back(overall_table(results, ranking));
        }
    }
    model["has_failures"] = !model["failures"].empty();
    model["has_gaps"] = !model["gaps"].empty();
    return model;
}

}  // namespace aoscore
