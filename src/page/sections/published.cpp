#include "core/counted.h"
#include "core/error.h"
#include "core/source_reference.h"
#include "metrics/evaluate.h"
#include "metrics/roles.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/tuned_rows.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace aoscore {
namespace {

using nlohmann::json;

/// The parameters of a method among a source's printed numbers; the rest of `published` is time and cost.
constexpr std::array kPublishedParameters = {"samples", "steps", "radius", "bias", "sigma", "kappa"};

/// A number that a source printed, and a different one that it printed elsewhere.
struct Printed {
    std::optional<double> value, other;
    std::string other_place;
};

std::optional<double> number_in(const json& object, const std::string& key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
}

Printed printed(const json& row, const std::string& key) {
    Printed result;
    result.value = number_in(row.at("published"), key);
    const json alternatives = row.value("alternatives", json::object());
    if (const auto found = alternatives.find(key); found != alternatives.end()) {
        result.other = found->at(0).get<double>();
        result.other_place = found->at(1).get<std::string>();
    }
    return result;
}

/// Applies an operation to both of the printed numbers.
template <class Operation>
Printed derived(const Printed& from, Operation operation) {
    return {operation(from.value), from.other ? operation(from.other) : std::nullopt, from.other_place};
}

json number_model(const Printed& number, int decimals) {
    json model = {{"text", fixed_text(number.value, decimals)}, {"contradicted", number.other.has_value()}};
    if (number.other) {
        model["other"] = fmt::format("{} ({})", fixed_text(number.other, decimals), number.other_place);
    }
    return model;
}

json number_model(std::optional<double> number, int decimals) {
    return number_model(Printed{number, std::nullopt, ""}, decimals);
}

json published_parameters(const json& row) {
    json list = json::array();
    for (const char* name : kPublishedParameters) {
        const Printed number = printed(row, name);
        if (!number.value && !number.other) continue;
        std::string text = number.value ? short_text(*number.value) : "not printed";
        if (number.other)
            text += fmt::format(" ({} in the {})", short_text(*number.other), number.other_place);
        list.push_back({{"name", name}, {"value", text}});
    }
    return list;
}

json our_parameters(const CellRecord& cell) {
    json list = json::array();
    for (const auto& [name, value] : cell.parameters) {
        list.push_back(
            {{"name", name}, {"value", value.is_number() ? short_text(value.number()) : value.text()}});
    }
    if (cell.filter != "none") list.push_back({{"name", "filter"}, {"value", cell.filter}});
    return list;
}

std::optional<double> own_value(const CellRecord& cell, const std::string& metric) {
    if (!cell.error.empty()) return std::nullopt;
    return value_of(cell.own, metric);
}

/// A row of a table: the definition's row and its cell.
struct TableRow {
    const json& published;
    const CellRecord& cell;
};

std::vector<TableRow> rows_of(const TableRecord& table, const Results& results) {
    const json& rows = table.definition.at("rows");
    if (rows.size() != table.cell_ids.size()) {
        throw file_error(
            fmt::format("has {} cells for a table of {} rows", table.cell_ids.size(), rows.size()),
            "results.json: tables");
    }
    std::vector<TableRow> list;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const CellRecord* cell = find_cell(results, table.cell_ids[i]);
        if (cell == nullptr)
            throw file_error("names a cell that it lacks, " + table.cell_ids[i], "results.json: tables");
        list.push_back({rows[i], *cell});
    }
    return list;
}

/// Pairs of the source's printed number and our measurement.
json cost_pairs(const std::vector<TableRow>& rows, const TableRow& row) {
    const Printed ao = printed(row.published, "ao_ms");
    const auto first_ao = printed(rows.front().published, "ao_ms").value;
    const auto fetches = printed(row.published, "fetches").value;
    const auto per_first = [&](std::optional<double> ms) { return ratio(ms, first_ao); };
    const auto per_fetch = [&](std::optional<double> ms) { return ratio(ms, fetches); };

    const CellRecord& cell = row.cell;
    std::vector<std::optional<double>> all_ms;
    for (const TableRow& other : rows) all_ms.push_back(other.cell.frame_ms);
    const int decimals = column_decimals(all_ms);
    const auto pair = [](json published, json ours) {
        return json{{"published", std::move(published)}, {"ours", std::move(ours)}};
    };
    return json::array(
        {pair(number_model(ao, 2), number_model(cell.ao.median_ms, decimals)),
         pair(number_model(derived(ao, per_first), 2),
              number_model(ratio(cell.ao.median_ms, rows.front().cell.ao.median_ms), 2)),
         pair(number_model(printed(row.published, "blur_ms"), 2),
              number_model(cell.filter_pass.median_ms, decimals)),
         pair(number_model(printed(row.published, "frame_ms"), 2), number_model(cell.frame_ms, decimals)),
         pair(number_model(fetches, 0), number_model(cell.fetches_per_pixel, 1)),
         pair(number_model(derived(ao, per_fetch), 3),
              number_model(ratio(cell.ao.median_ms, cell.fetches_per_pixel), 3))});
}

json error_numbers(const CellRecord& cell, const std::string& metric) {
    json list = json::array();
    const std::array<std::string, 3> ids{metric, kBiasMetric, kStructureMetric};
    for (const std::string& id : ids) list.push_back(number_model(ranked_value(cell, id), 4));
    for (const std::string& id : ids) list.push_back(number_model(own_value(cell, id), 4));
    return list;
}

/// Empty where no picture was stored.
json thumbnails(const std::vector<TableRow>& rows, const Pictures& pictures) {
    const auto view = pictures.views.find(rows.front().cell.view_key);
    if (view == pictures.views.end()) return json::array();
    json model = {{"reference", view->second.truth_thumbnail.uri},
                  {"outputs", json::array()},
                  {"has_raws", false},
                  {"columns", std::to_string(rows.size() + 1)}};
    for (const TableRow& row : rows) {
        const auto found = pictures.cells.find(row.cell.id);
        const bool shown = found != pictures.cells.end();
        const std::string raw = shown ? found->second.raw_thumbnail.uri : "";
        if (!raw.empty()) model["has_raws"] = true;
        model["outputs"].push_back({{"method", shown_name(row.cell)},
                                    {"shown", shown},
                                    {"uri", shown ? found->second.output_thumbnail.uri : ""},
                                    {"has_raw", !raw.empty()},
                                    {"raw", raw}});
    }
    return model;
}

json notes_of(const TableRecord& table, const std::vector<TableRow>& rows) {
    json list = json::array();
    for (const TableRow& row : rows) {
        for (const json& note : row.published.value("notes", json::array())) {
            list.push_back(
                {{"about", shown_name(row.cell)}, {"has_about", true}, {"text", note.get<std::string>()}});
        }
    }
    for (const json& note : table.definition.value("notes", json::array())) {
        list.push_back({{"about", ""}, {"has_about", false}, {"text", note.get<std::string>()}});
    }
    return list;
}

json table_model(const TableRecord& table, const PageSource& source) {
    const json& definition = table.definition;
    const std::vector<TableRow> rows = rows_of(table, source.results);
    if (rows.empty()) throw file_error("holds a table without rows", "results.json: tables");
    const ViewRecord& view = find_view(source.results, rows.front().cell.view_key);
    std::vector<const CellRecord*> cells;
    for (const TableRow& row : rows) cells.push_back(&row.cell);
    const std::string metric = ranking_metric(cells);

    json model = {
        {"id", definition.at("id").get<std::string>()},
        {"title", definition.at("title").get<std::string>()},
        {"source", source_reference(StrictObject(definition.at("source"), "results.json: tables: source"))},
        {"hardware", definition.at("hardware").get<std::string>()},
        {"view", view.key},
        {"size", fmt::format("{}×{}", view.width, view.height)},
        {"samples", std::to_string(view.samples)},
        {"radius", short_text(view.radius_m)},
        {"renderer", source.results.gl_renderer},
        {"metric", std::string(aoscore::metric(metric).label)},
        {"thumbnails", thumbnails(rows, source.pictures)},
        {"notes", notes_of(table, rows)},
        {"tuned", tuned_rows_model(table, cells)},
        {"rows", json::array()}};
    for (const TableRow& row : rows) {
        const TruthRecord* own = find_truth(view, row.cell.own_truth);
        model["rows"].push_back({{"method", shown_name(row.cell)},
                                 {"cell", row.cell.id},
                                 {"preset", row.cell.preset},
                                 {"failed", !row.cell.error.empty()},
                                 {"error", row.cell.error},
                                 {"published_parameters", published_parameters(row.published)},
                                 {"our_parameters", our_parameters(row.cell)},
                                 {"pairs", cost_pairs(rows, row)},
                                 {"errors", error_numbers(row.cell, metric)},
                                 {"own_truth", own != nullptr ? truth_text(*own) : kNoNumber}});
    }
    return model;
}

}  // namespace

nlohmann::json section::published(const PageSource& source) {
    std::size_t rows = 0;
    for (const TableRecord& table : source.results.tables) rows += table.cell_ids.size();
    const std::size_t tables = source.results.tables.size();
    json model = {{"tables", json::array()},
                  {"in_short", fmt::format("{} with {} {} beside what this run measured.",
                                           counted(tables, "published table", "published tables"),
                                           counted(rows, "row", "rows"), tables == 1 ? "stands" : "stand")}};
    for (const TableRecord& table : source.results.tables) {
        try {
            model["tables"].push_back(table_model(table, source));
        } catch (const json::exception& e) {
            throw file_error(std::string("holds a definition of another form: ") + e.what(),
                             "results.json: tables");
        }
    }
    return model;
}

}  // namespace aoscore
