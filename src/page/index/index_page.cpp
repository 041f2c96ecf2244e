#include "page/index/index_page.h"

#include "core/counted.h"
#include "core/files.h"
#include "core/folders.h"
#include "page/document/html_document.h"
#include "page/document/number_text.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"
#include "page/index/scene_ranking.h"
#include "results/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string rank_of(const ScenePlace& place, const IndexedContestant& contestant) {
    if (contestant.role == kBoundRole) return kBoundRole;
    PlaceRecord record;
    record.rank = place.rank;
    return place.rank ? rank_text(record) : kNoNumber;
}

std::string view_name(const IndexedView& view) {
    return view.scene + "/" + view.view;
}

/// How many cameras stand there at more than one radius or size.
std::size_t repeated_cameras(const IndexContents& contents) {
    std::map<std::string, int> counts;
    for (const IndexedView& view : contents.views) ++counts[view_name(view)];
    return static_cast<std::size_t>(
        std::ranges::count_if(counts, [](const auto& entry) { return entry.second > 1; }));
}

json place_model(const ScenePlace& place, const IndexContents& contents, double largest,
                 bool several_scenes) {
    const IndexedContestant& contestant = contents.contestants[place.contestant];
    const IndexedCell& worst = contents.cells[place.worst_cell];
    const auto at = [&](double error) { return fmt::format("{:.2f}%", 100 * error / largest); };
    const Interval span = place.interval.value_or(Interval{place.error, place.error});
    const std::string behind = place.behind_first
                                   ? fmt::format("{} to {}", fixed_text(place.behind_first->low, 4),
                                                 fixed_text(place.behind_first->high, 4))
                                   : kNoNumber;
    return {{"rank", rank_of(place, contestant)},
            {"name", contestant.name},
            {"error", fixed_text(place.error, 4)},
            {"interval", several_scenes && place.interval
                             ? fmt::format("{} to {}", fixed_text(span.low, 4), fixed_text(span.high, 4))
                             : kNoNumber},
            {"low", at(span.low)},
            {"high", at(span.high)},
            {"at", at(place.error)},
            {"behind", behind},
            {"worst", view_name(contents.views[worst.view])},
            {"worst_error", fixed_text(worst.error, 4)},
            {"has_link", !worst.link.empty()},
            {"worst_link", worst.link},
            {"ms", fixed_text(place.ms, 1)},
            {"fetches", fixed_text(place.fetches, 1)}};
}

json number(const std::optional<double>& value) {
    return value ? json(*value) : json();
}

/// The error of light in per cent, its mode and the environment; null for a cell that was not lit.
json light_model(const IndexedCell& cell) {
    if (!cell.light) return nullptr;
    return {100 * cell.light->relative_error, cell.light->mode, cell.light->environment};
}

/// What the script shows: views, contestants in the ranking's order, and cells as rows of numbers and texts.
json data_model(const IndexContents& contents, const SceneRanking& ranking) {
    json views = json::array(), contestants = json::array(), cells = json::array(), order = json::array();
    for (const IndexedView& view : contents.views)
        views.push_back({{"scene", view.scene},
                         {"view", view.view},
                         {"size", fmt::format("{}×{}", view.width, view.height)},
                         {"radius", short_text(view.radius_m)},
                         {"picture", view.picture}});
    for (const IndexedContestant& contestant : contents.contestants)
        contestants.push_back({{"name", contestant.name}});
    for (const ScenePlace& place : ranking.places) order.push_back(place.contestant);
    for (const IndexedCell& cell : contents.cells)
        cells.push_back({cell.view, cell.contestant, number(cell.error),
                         cell.interval ? json(cell.interval->low) : json(),
                         cell.interval ? json(cell.interval->high) : json(), number(cell.bias), cell.rank,
                         number(cell.ms), number(cell.fetches), cell.link, cell.failure, light_model(cell)});
    return {{"views", std::move(views)},
            {"contestants", std::move(contestants)},
            {"order", std::move(order)},
            {"cells", std::move(cells)}};
}

json page_model(const IndexContents& contents, const SceneRanking& ranking, const std::string& command) {
    const std::size_t repeated = repeated_cameras(contents);
    double largest = 0;
    for (const ScenePlace& place : ranking.places)
        largest = std::max(largest, place.interval ? place.interval->high : place.error);
    json places = json::array(), unreadable = json::array(), replaced = json::array();
    std::size_t all_replaced = 0;
    for (const auto& [folder, cells] : contents.replaced) {
        replaced.push_back({{"folder", folder}, {"cells", counted(cells, "cell", "cells")}});
        all_replaced += cells;
    }
    for (const ScenePlace& place : ranking.places)
        places.push_back(place_model(place, contents, largest > 0 ? largest : 1, ranking.scenes > 1));
    for (const UnreadableResults& one : contents.unreadable)
        unreadable.push_back({{"path", one.path}, {"reason", one.reason}});
    return {{"version", std::string(version())},
            {"command", command},
            {"verdict", scene_sentence(ranking, contents)},
            {"has_places", !places.empty()},
            {"places", std::move(places)},
            {"counts", fmt::format("{} with {} on {}", counted(contents.read, "run", "runs"),
                                   counted(contents.cells.size(), "cell", "cells"),
                                   counted(contents.views.size(), "view", "views"))},
            {"ranked_over", fmt::format("{} of {}", counted(ranking.views, "view", "views"),
                                        counted(ranking.scenes, "scene", "scenes"))},
            {"several_scenes", ranking.scenes > 1},
            {"has_light",
             std::ranges::any_of(contents.cells, [](const IndexedCell& c) { return c.light.has_value(); })},
            {"has_repeated", repeated > 0},
            {"repeated", counted(repeated, "camera stands", "cameras stand")},
            {"has_left_out", ranking.left_out > 0},
            {"left_out", counted(ranking.left_out, "contestant was", "contestants were")},
            {"has_replaced", !replaced.empty()},
            {"replaced_count", counted(all_replaced, "cell is", "cells are")},
            {"replaced", std::move(replaced)},
            {"has_unreadable", !unreadable.empty()},
            {"unreadable_count", counted(unreadable.size(), "file could", "files could")},
            {"unreadable", std::move(unreadable)},
            {"data", script_json(data_model(contents, ranking))}};
}

}  // namespace

fs::path write_index_page(const IndexContents& contents, const fs::path& folder, const std::string& command,
                          std::uint64_t seed) {
    const fs::path parts = data_dir() / "reports" / "index";
    const json model = page_model(contents, rank_over_scenes(contents, seed), command);
    const fs::path frame = parts / "template.html", path = folder / "index.html";
    write_atomically(
        path,
        html_text({"index", read_file(page_folder() / "style" / "page.css") + read_file(parts / "style.css"),
                   closed_script(page_scripts({"make.js", "columns.js"}) + read_file(parts / "script.js")),
                   fill_template(read_file(frame), model, frame.string())}));
    return path;
}

}  // namespace aoscore
