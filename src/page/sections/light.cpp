#include "page/document/number_text.h"
#include "page/pictures/lit_picture.h"
#include "page/section.h"
#include "results/light_errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;
using LightMap = std::map<std::string, MeasureRecord>;

/// What the table shows of every mode.
struct LightColumn {
    std::string (LightMode::*id)() const;
    std::string_view unit, meaning;
};
constexpr std::array kLightColumns{
    LightColumn{
        &LightMode::relative_error, "error, %",
        "Root mean squared error of the luminance of irradiance over the mean of the traced one, less the "
        "noise of its rays."},
    LightColumn{&LightMode::bias, "bias, %",
                "Mean error over the mean of the traced irradiance: above 0 is too bright."}};

std::string lit_name(const CellRecord& cell) {
    return fmt::format("{}, {}", shown_name(cell), cell.preset);
}

const MeasureRecord* measure_in(const LightMap& light, const std::string& id) {
    const auto found = light.find(id);
    return found == light.end() ? nullptr : &found->second;
}

/// The cells of a view that are lit, least error first.
std::vector<const CellRecord*> lit_cells(const Results& results, const ViewRecord& view) {
    std::vector<const CellRecord*> cells;
    for (const CellRecord& cell : results.cells) {
        if (cell.view_key == view.key && least_light_error(cell.light)) cells.push_back(&cell);
    }
    std::ranges::stable_sort(
        cells, {}, [](const CellRecord* cell) { return least_light_error(cell->light)->error->value; });
    return cells;
}

json light_number(const LightMap& light, const LightMode& mode, const LightColumn& column) {
    const MeasureRecord* measure = measure_in(light, (mode.*column.id)());
    if (measure == nullptr)
        return {{"text", kNoNumber}, {"sort", ""}, {"note", "it lacks the signals"}, {"interval", ""}};
    std::string interval;
    if (measure->interval) {
        interval = fmt::format("{} to {}", percent_text(measure->interval->low, 1),
                               percent_text(measure->interval->high, 1));
    }
    return {{"text", percent_text(measure->value, 1)},
            {"sort", fmt::format("{}", measure->value)},
            {"note", interval.empty() ? "" : "between these with 95 % confidence"},
            {"interval", std::move(interval)}};
}

json light_row(const std::string& name, const std::string& cell, const LightMap& light) {
    json numbers = json::array();
    for (const LightColumn& column : kLightColumns) {
        for (const LightMode& mode : light_modes()) numbers.push_back(light_number(light, mode, column));
    }
    return {{"method", name}, {"has_cell", !cell.empty()}, {"cell", cell}, {"numbers", std::move(numbers)}};
}

json light_heads() {
    json list = json::array();
    for (const LightColumn& column : kLightColumns) {
        for (const LightMode& mode : light_modes()) {
            list.push_back({{"label", std::string(mode.label)},
                            {"unit", std::string(column.unit)},
                            {"meaning", fmt::format("{} {}", mode.meaning, column.meaning)}});
        }
    }
    return list;
}

/// A lit cell with its pictures.
struct ShownCell {
    const CellRecord* cell;
    const CellPictures* pictures;
};

/// The picture of a cell by a mode under this label; null where it has none.
json lit_figure(const ShownCell& shown, const LightMode& mode, const std::string& label) {
    const auto lit = shown.pictures->lit.find(std::string(mode.id));
    if (lit == shown.pictures->lit.end()) return nullptr;
    return {{"label", label},
            {"name", lit_name(*shown.cell)},
            {"mode", std::string(mode.label)},
            {"uri", lit->second.uri},
            {"error", shown.pictures->lit_errors.at(std::string(mode.id)).uri},
            {"number", percent_text(measure_in(shown.cell->light, mode.relative_error())->value, 1)}};
}

json lit_group(const std::string& title, json figures) {
    return {{"title", title}, {"figures", std::move(figures)}};
}

/// Pictures side by side: the methods by each mode, or the modes of the only method.
json lit_groups(const std::vector<ShownCell>& cells) {
    json groups = json::array();
    const bool alone = cells.size() == 1;
    json of_one = json::array();
    for (const LightMode& mode : light_modes()) {
        json figures = json::array();
        for (const ShownCell& shown : cells) {
            json figure = lit_figure(shown, mode, alone ? std::string(mode.label) : lit_name(*shown.cell));
            if (!figure.is_null()) (alone ? of_one : figures).push_back(std::move(figure));
        }
        if (!figures.empty())
            groups.push_back(lit_group("By the " + std::string(mode.label), std::move(figures)));
    }
    if (!of_one.empty()) groups.push_back(lit_group(lit_name(*cells[0].cell), std::move(of_one)));
    return groups;
}

json lit_view(const PageSource& source, const ViewRecord& view) {
    const LightRecord& light = *view.light;
    json rows = json::array();
    std::vector<ShownCell> shown_cells;
    if (!light.of_truth.empty()) rows.push_back(light_row("Truth", "", light.of_truth));
    for (const CellRecord* cell : lit_cells(source.results, view)) {
        rows.push_back(light_row(lit_name(*cell), cell->id, cell->light));
        const auto shown = source.pictures.cells.find(cell->id);
        if (shown == source.pictures.cells.end() || shown->second.lit.empty()) continue;
        shown_cells.push_back({cell, &shown->second});
    }
    const auto pictures = source.pictures.views.find(view.key);
    const bool has_picture = pictures != source.pictures.views.end() && pictures->second.irradiance;
    return {{"key", view.key},
            {"environment", light.environment == "sky" ? "the generated sky" : light.environment},
            {"mean", fmt::format("{:.3g}", light.mean)},
            {"noise",
             percent_text(light.mean > 0 ? std::optional(light.standard_error / light.mean) : std::nullopt)},
            {"samples", count_text(static_cast<std::size_t>(light.samples))},
            {"radius", short_text(view.radius_m)},
            {"truth_samples", count_text(static_cast<std::size_t>(view.samples))},
            {"heads", light_heads()},
            {"rows", std::move(rows)},
            {"has_pictures", has_picture},
            {"traced", has_picture ? pictures->second.irradiance.uri : ""},
            {"white", has_picture ? fmt::format("{:.3g}", pictures->second.irradiance_white) : ""},
            {"range", percent_text(kLitErrorRange, 0)},
            {"groups", lit_groups(shown_cells)}};
}

/// Whether the interval of a method's error reaches down to that of the least one.
bool may_be_as_close(const MeasureRecord& least, const MeasureRecord& error) {
    if (!least.interval || !error.interval) return error.value <= least.value;
    return error.interval->low <= least.interval->high;
}

/// How close the lit cells of a view come, least error first; at least one.
std::string closeness_text(const std::string& view, const std::vector<const CellRecord*>& cells) {
    constexpr std::size_t kNamed = 4;
    const auto [least, mode] = *least_light_error(cells[0]->light);
    const std::string error = percent_text(least->value, 1);
    if (cells.size() == 1) {
        return fmt::format(
            "On {}, {} lights with an error of {} % of the mean of the ray-traced irradiance, by its {}.",
            view, lit_name(*cells[0]), error, mode->label);
    }
    std::vector<std::string> names;
    for (const CellRecord* cell : cells) {
        if (may_be_as_close(*least, *least_light_error(cell->light)->error)) names.push_back(lit_name(*cell));
    }
    if (names.size() == 1) {
        return fmt::format(
            "On {}, {} lights closest of {} methods to the ray-traced irradiance, by its {}: the "
            "error is {} % of the mean.",
            view, names[0], cells.size(), mode->label, error);
    }
    const std::size_t equal = names.size();
    if (equal > kNamed) {
        names.resize(kNamed - 1);
        names.push_back(fmt::format("{} others", equal - names.size()));
    }
    const std::string how_many =
        equal == cells.size() ? fmt::format("all {}", equal) : fmt::format("{} of {}", equal, cells.size());
    return fmt::format(
        "On {}, {} methods light equally close to the ray-traced irradiance, as far as the intervals tell: "
        "{}. The least error is {} % of the mean.",
        view, how_many, fmt::join(names, "; "), error);
}

/// How close methods come on the first view with light.
std::string light_in_short(const Results& results) {
    for (const ViewRecord& view : results.views) {
        if (!view.light) continue;
        const std::vector<const CellRecord*> cells = lit_cells(results, view);
        if (!cells.empty()) return closeness_text(view.key, cells);
    }
    return "No method could be lit.";
}

}  // namespace

json section::light(const PageSource& source) {
    json views = json::array(), modes = json::array();
    for (const ViewRecord& view : source.results.views) {
        if (view.light) views.push_back(lit_view(source, view));
    }
    for (const LightMode& mode : light_modes())
        modes.push_back({{"label", std::string(mode.label)}, {"meaning", std::string(mode.meaning)}});
    return {{"views", std::move(views)},
            {"modes", std::move(modes)},
            {"in_short", light_in_short(source.results)}};
}

}  // namespace aoscore
