#include "page/index/scene_ranking.h"

#include "core/counted.h"
#include "metrics/evaluate.h"
#include "metrics/roles.h"
#include "page/document/number_text.h"
#include "page/sections/closest_sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace aoscore {
namespace {

using Cells = std::vector<const IndexedCell*>;

std::optional<double> median_of(const Cells& cells, std::optional<double> IndexedCell::*member) {
    std::vector<double> values;
    for (const IndexedCell* cell : cells) {
        if (cell->*member) values.push_back(*(cell->*member));
    }
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Errors by scene in the order of the views, alike for all contestants on the same views.
ErrorsByScene by_scene(const Cells& cells, const IndexContents& contents) {
    std::map<std::string, std::vector<double>> scenes;
    for (const IndexedCell* cell : cells) scenes[contents.views[cell->view].scene].push_back(*cell->error);
    ErrorsByScene errors;
    for (auto& [scene, views] : scenes) errors.push_back(std::move(views));
    return errors;
}

using ViewSet = std::set<std::size_t>;

ViewSet views_of(const Cells& cells) {
    ViewSet views;
    for (const IndexedCell* cell : cells) views.insert(cell->view);
    return views;
}

/// The views that are ranked over: those that the first k contestants share, with the k at which k times
/// their number is largest.
ViewSet shared_views(const std::vector<Cells>& most_views_first) {
    ViewSet shared, best;
    std::size_t most = 0;
    for (std::size_t i = 0; i < most_views_first.size(); ++i) {
        const ViewSet views = views_of(most_views_first[i]);
        if (i == 0) shared = views;
        std::erase_if(shared, [&](std::size_t view) { return !views.contains(view); });
        const std::size_t compared = (i + 1) * shared.size();
        if (i > 0 && compared < most) continue;
        most = compared;
        best = shared;
    }
    return best;
}

/// The cells with an error of each contestant, in the order of the views.
std::vector<Cells> cells_of_contestants(const IndexContents& contents) {
    std::vector<Cells> all(contents.contestants.size());
    for (const IndexedCell& cell : contents.cells) {
        if (cell.error) all[cell.contestant].push_back(&cell);
    }
    for (Cells& cells : all) std::ranges::sort(cells, {}, &IndexedCell::view);
    return all;
}

ScenePlace place_of(const Cells& cells, const Resampled& error, const IndexContents& contents) {
    ScenePlace place;
    place.contestant = cells.front()->contestant;
    place.error = error.value;
    place.interval = confidence_interval(error.draws);
    const auto worst =
        std::ranges::max_element(cells, {}, [](const IndexedCell* cell) { return *cell->error; });
    place.worst_cell = static_cast<std::size_t>(*worst - contents.cells.data());
    place.ms = median_of(cells, &IndexedCell::ms);
    place.fetches = median_of(cells, &IndexedCell::fetches);
    return place;
}

void add_ranks(std::vector<ScenePlace>& places, const std::vector<Resampled>& errors,
               const IndexContents& contents) {
    std::vector<std::size_t> ranked;
    std::vector<Resampled> of_ranked;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (contents.contestants[places[i].contestant].role == kBoundRole) continue;
        ranked.push_back(i);
        of_ranked.push_back(errors[i]);
    }
    const Ranks ranks(of_ranked);
    for (std::size_t i = 0; i < ranked.size(); ++i) {
        places[ranked[i]].rank = ranks.range(i);
        if (i > 0) places[ranked[i]].behind_first = ranks.difference(i, 0);
    }
}

}  // namespace

SceneRanking rank_over_scenes(const IndexContents& contents, std::uint64_t seed) {
    std::vector<Cells> contestants = cells_of_contestants(contents);
    std::ranges::stable_sort(contestants, std::greater<>(), &Cells::size);
    const ViewSet views = shared_views(contestants);
    for (Cells& cells : contestants)
        std::erase_if(cells, [&](const IndexedCell* cell) { return !views.contains(cell->view); });
    SceneRanking ranking;
    ranking.left_out = std::erase_if(
        contestants, [&](const Cells& cells) { return cells.empty() || cells.size() < views.size(); });
    std::set<std::string> scenes;
    for (const std::size_t view : views) scenes.insert(contents.views[view].scene);
    ranking.views = views.size();
    ranking.scenes = scenes.size();
    std::vector<std::pair<Resampled, const Cells*>> order;
    for (const Cells& cells : contestants)
        order.emplace_back(over_scenes(by_scene(cells, contents), seed), &cells);
    std::ranges::stable_sort(order, {}, [](const auto& entry) { return entry.first.value; });
    std::vector<Resampled> errors;
    for (auto& [error, cells] : order) {
        ranking.places.push_back(place_of(*cells, error, contents));
        errors.push_back(std::move(error));
    }
    if (ranking.scenes > 1) add_ranks(ranking.places, errors, contents);
    return ranking;
}

std::string scene_sentence(const SceneRanking& ranking, const IndexContents& contents) {
    const std::string over = fmt::format("over {} with {}", counted(ranking.scenes, "scene", "scenes"),
                                         counted(ranking.views, "view", "views"));
    const auto name = [&](const ScenePlace& place) { return contents.contestants[place.contestant].name; };
    if (ranking.places.empty()) return "No method could be scored.";
    if (ranking.scenes < 2)
        return "The methods share only one scene, so it cannot be told how far its ranking carries over to "
               "others.";
    std::vector<const ScenePlace*> leaders;
    std::size_t ranked = 0;
    for (const ScenePlace& place : ranking.places) {
        if (!place.rank) continue;
        ++ranked;
        if (place.rank->best == 1) leaders.push_back(&place);
    }
    if (leaders.empty()) return "Only bounds were scored.";
    ClosestMethods closest{.leaders = {},
                           .ranked = ranked,
                           .where = over,
                           .metric = std::string(metric(kRankingMetric).in_text),
                           .value = fixed_text(leaders[0]->error, 4)};
    for (const ScenePlace* place : leaders) {
        closest.leaders.push_back(leaders.size() == 1
                                      ? name(*place)
                                      : fmt::format("{} ({})", name(*place), fixed_text(place->error, 4)));
    }
    return closest_sentence(closest);
}

}  // namespace aoscore
