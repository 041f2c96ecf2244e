#include "core/counted.h"
#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/listing.h"
#include "page/sections/place_name.h"
#include "page/sections/ranking_sentence.h"
#include "page/sections/truth_noise_text.h"
#include "page/sections/view_looks.h"
#include "results/advice_text.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace aoscore {
namespace {

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
        return fmt::format("Several methods tie as the closest to the ray-traced truth on each of {} views.",
                           compared);
    if (wins.size() == 1 && untold == 0) {
        return fmt::format("{} is closest to the ray-traced truth on each of {} views.", wins.begin()->first,
                           compared);
    }
    std::vector<std::pair<std::string, int>> order(wins.begin(), wins.end());
    std::ranges::stable_sort(order, std::greater<>(), &std::pair<std::string, int>::second);
    std::vector<std::string> parts;
    for (const auto& [name, won] : order) parts.push_back(fmt::format("{} on {}", name, won));
    const std::string ties = untold > 0 ? fmt::format("; several methods tie on {}", untold) : "";
    return fmt::format("Of {} views, the closest method to the ray-traced truth is {}{}.", compared,
                       listed(std::move(parts)), ties);
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
    for (const RankingRecord* part : parts) text += (text.empty() ? "" : " ") + ranking_sentence(*part);
    return text;
}

}  // namespace

nlohmann::json section::verdict(const PageSource& source) {
    const Results& results = source.results;
    std::vector<const RankingRecord*> views;
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() == 1) views.push_back(&ranking);
    }
    nlohmann::json model = {{"lead", lead_text(results, views)},
                            {"details", nlohmann::json::array()},
                            {"looks", view_looks(source)}};
    model["several"] = model["looks"].size() > 1;
    const auto add_detail = [&](std::string text) {
        if (!text.empty()) model["details"].push_back(std::move(text));
    };
    for (const RankingRecord* view : views) {
        if (views.size() > 1) add_detail(ranking_sentence(*view));
        add_detail(bounds_sentence(*view));
    }
    add_detail(leading_advice(results));
    for (const ViewRecord& view : results.views) add_detail(truth_noise_text(results, view));
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
