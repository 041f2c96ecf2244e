#include "core/counted.h"
#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/place_name.h"
#include "page/sections/truth_noise_text.h"
#include "results/ranked_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace aoscore {
namespace {

/// The number of names in a sentence; the table has all of them.
constexpr std::size_t kListed = 4;

using Places = std::vector<const PlaceRecord*>;

/// The places that have a rank, in the order of their error.
Places ranked_places(const RankingRecord& ranking) {
    Places places;
    for (const PlaceRecord& place : ranking.places) {
        if (place.rank) places.push_back(&place);
    }
    return places;
}

/// The places that may have the least error.
Places leaders_of(const RankingRecord& ranking) {
    Places places = ranked_places(ranking);
    std::erase_if(places, [](const PlaceRecord* place) { return place->rank->best > 1; });
    return places;
}

std::string listed(std::vector<std::string> names) {
    if (names.size() > kListed + 1) {
        const std::size_t more = names.size() - kListed;
        names.resize(kListed);
        names.push_back(fmt::format("{} more", more));
    }
    if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
    const std::string last = names.back();
    names.pop_back();
    return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

/// The views of a ranking in words: "On atrium/wide", "Over atrium/wide and atrium/close at R 0.5 m".
std::string where_text(const RankingRecord& ranking) {
    if (ranking.view_keys.size() == 1) return "On " + ranking.view_keys.front();
    return fmt::format("Over {} at R {} m", listed(ranking.view_keys), short_text(ranking.radius_m));
}

std::string cost_clause(const CellRecord& best, const CellRecord& second) {
    std::vector<std::string> costs;
    if (const auto times = ratio(cost_ms(best), cost_ms(second))) {
        costs.push_back(fmt::format("{} times its milliseconds", fixed_text(times, 2)));
    }
    if (best.fetches_per_pixel && second.fetches_per_pixel) {
        costs.push_back(fmt::format("{} against {} fetches a pixel", fixed_text(best.fetches_per_pixel, 1),
                                    fixed_text(second.fetches_per_pixel, 1)));
    }
    if (costs.empty()) return "";
    return ", at " + costs.front() + (costs.size() > 1 ? " and " + costs.back() : "");
}

/// Compares the first with the second place in error and cost; for one view only.
std::string lead_clause(const Results& results, const RankingRecord& ranking, const PlaceRecord& best,
                        const PlaceRecord& second) {
    std::string text;
    if (const auto part = ratio(second.value - best.value, second.value)) {
        text = fmt::format(", {} % below {}", percent_text(part, 0), place_name(ranking, second));
    }
    const CellRecord* first_cell = find_cell(results, best.cell_ids.front());
    const CellRecord* second_cell = find_cell(results, second.cell_ids.front());
    if (ranking.view_keys.size() > 1 || first_cell == nullptr || second_cell == nullptr) return text;
    return text + cost_clause(*first_cell, *second_cell);
}

std::string with_value(const RankingRecord& ranking, const PlaceRecord& place) {
    return fmt::format("{} ({})", place_name(ranking, place), fixed_text(place.value, 4));
}

/// A sentence with the errors of a ranking's bounds; empty without any.
std::string bounds_sentence(const RankingRecord& ranking) {
    std::vector<std::string> bounds;
    for (const PlaceRecord& place : ranking.places) {
        if (!place.rank) bounds.push_back(with_value(ranking, place));
    }
    return bounds.empty() ? ""
                          : fmt::format(" Beside the ranking, not for use: {}.", listed(std::move(bounds)));
}

std::string ranking_sentence(const Results& results, const RankingRecord& ranking) {
    const std::string where = where_text(ranking), metric(aoscore::metric(ranking.metric).in_text);
    const Places ranked = ranked_places(ranking), leaders = leaders_of(ranking);
    if (ranked.empty()) return where + " no method for use was scored.";
    const PlaceRecord& best = *ranked.front();
    const std::string name = place_name(ranking, best), value = fixed_text(best.value, 4);
    if (ranked.size() == 1) return fmt::format("{} {} alone was scored: {} {}.", where, name, metric, value);
    if (leaders.size() == 1) {
        return fmt::format("{} {} comes closest of {} to the ray-traced truth: {} {}{}.", where, name,
                           ranked.size(), metric, value, lead_clause(results, ranking, best, *ranked[1]));
    }
    std::vector<std::string> names;
    for (const PlaceRecord* place : leaders) names.push_back(with_value(ranking, *place));
    return fmt::format(
        "{} it cannot be told which of {} methods comes closest to the ray-traced truth: {} by {}.", where,
        ranked.size(), listed(std::move(names)), metric);
}

/// Counts the views on which each method has significantly the least error.
std::string counting_sentence(const std::vector<const RankingRecord*>& views) {
    std::map<std::string, int> wins;
    std::size_t compared = 0, untold = 0;
    for (const RankingRecord* ranking : views) {
        if (ranked_places(*ranking).size() < 2) continue;
        ++compared;
        const Places leaders = leaders_of(*ranking);
        if (leaders.size() == 1)
            ++wins[place_name(*ranking, *leaders.front())];
        else
            ++untold;
    }
    if (compared == 0) return "Nothing was compared: no view has two methods that were scored.";
    if (untold == compared)
        return fmt::format("On none of {} views can it be told which method comes closest to the truth.",
                           compared);
    if (wins.size() == 1 && untold == 0) {
        return fmt::format("{} comes closest to the ray-traced truth on each of {} views.",
                           wins.begin()->first, compared);
    }
    std::vector<std::pair<std::string, int>> order(wins.begin(), wins.end());
    std::ranges::stable_sort(order, std::greater<>(), &std::pair<std::string, int>::second);
    std::vector<std::string> parts;
    for (const auto& [name, won] : order) parts.push_back(fmt::format("{} on {}", name, won));
    if (untold > 0) parts.push_back(fmt::format("on {} it cannot be told", untold));
    return fmt::format(
        "Which method comes closest to the ray-traced truth depends on the view: of {} views {}.", compared,
        listed(std::move(parts)));
}

bool has_place(const RankingRecord& ranking, const std::string& cell_id) {
    return std::ranges::any_of(ranking.places, [&](const PlaceRecord& place) {
        return std::ranges::find(place.cell_ids, cell_id) != place.cell_ids.end();
    });
}

/// Whether the leaders of all its views have a place in a ranking over views, which may otherwise leave out
/// methods that were compared.
bool speaks_for(const RankingRecord& over, const std::vector<const RankingRecord*>& views) {
    return std::ranges::all_of(views, [&](const RankingRecord* view) {
        if (std::ranges::find(over.view_keys, view->view_keys.front()) == over.view_keys.end()) return true;
        const Places leaders = leaders_of(*view);
        return std::ranges::all_of(
            leaders, [&](const PlaceRecord* place) { return has_place(over, place->cell_ids.front()); });
    });
}

/// The rankings that together hold every view once, each over a whole group of comparable views; empty where
/// there are too many for a headline, or one leaves out a leader.
std::vector<const RankingRecord*> summary(const Results& results,
                                          const std::vector<const RankingRecord*>& views) {
    std::vector<const RankingRecord*> parts;
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() < 2) continue;
        if (!speaks_for(ranking, views)) return {};
        parts.push_back(&ranking);
    }
    for (const RankingRecord* view : views) {
        const bool covered = std::ranges::any_of(parts, [&](const RankingRecord* part) {
            return std::ranges::find(part->view_keys, view->view_keys.front()) != part->view_keys.end();
        });
        if (!covered) parts.push_back(view);
    }
    return parts.size() <= 2 ? parts : std::vector<const RankingRecord*>();
}

std::string lead_text(const Results& results, const std::vector<const RankingRecord*>& views) {
    if (views.empty()) return "No method could be scored.";
    const std::vector<const RankingRecord*> parts = summary(results, views);
    if (parts.empty()) return counting_sentence(views);
    std::string text;
    for (const RankingRecord* part : parts)
        text += (text.empty() ? "" : " ") + ranking_sentence(results, *part) + bounds_sentence(*part);
    return text;
}

}  // namespace

nlohmann::json section::verdict(const PageSource& source) {
    const Results& results = source.results;
    std::vector<const RankingRecord*> views;
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() == 1) views.push_back(&ranking);
    }
    nlohmann::json model = {{"lead", lead_text(results, views)}, {"details", nlohmann::json::array()}};
    if (views.size() > 1) {
        for (const RankingRecord* view : views)
            model["details"].push_back(ranking_sentence(results, *view) + bounds_sentence(*view));
    }
    for (const ViewRecord& view : results.views) {
        if (std::string text = truth_noise_text(results, view); !text.empty())
            model["details"].push_back(std::move(text));
    }
    const std::string first_answer = first_answer_text(results);
    model["goes_on"] = !first_answer.empty();
    model["first_answer"] = first_answer;
    const auto failed =
        std::ranges::count_if(results.cells, [](const auto& cell) { return !cell.error.empty(); });
    model["failed"] = failed > 0;
    model["failed_count"] = counted(static_cast<std::size_t>(failed), "cell failed and is not ranked",
                                    "cells failed and are not ranked");
    return model;
}

}  // namespace aoscore
