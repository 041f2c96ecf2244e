#include "page/sections/ranking_sentence.h"

#include "metrics/evaluate.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/closest_sentence.h"
#include "page/sections/listing.h"
#include "page/sections/place_name.h"

#include <fmt/format.h>

#include <cctype>

namespace aoscore {
namespace {

/// The views of a ranking in words: "on atrium/wide", "over atrium/wide and atrium/close (R 0.5 m)".
std::string where_text(const RankingRecord& ranking) {
    if (ranking.view_keys.size() == 1) return "on " + ranking.view_keys.front();
    return fmt::format("over {} (R {} m)", listed(ranking.view_keys), short_text(ranking.radius_m));
}

std::string with_value(const RankingRecord& ranking, const PlaceRecord& place) {
    return fmt::format("{} ({})", place_name(ranking, place), fixed_text(place.value, 4));
}

std::string in_percent(double part) {
    return percent_text(part, 0) + " %";
}

std::string with_capital(std::string sentence) {
    if (!sentence.empty()) sentence[0] = static_cast<char>(std::toupper(sentence[0]));
    return sentence;
}

}  // namespace

Places ranked_places(const RankingRecord& ranking) {
    Places places;
    for (const PlaceRecord& place : ranking.places) {
        if (place.rank) places.push_back(&place);
    }
    return places;
}

Places leaders_of(const RankingRecord& ranking) {
    Places places = ranked_places(ranking);
    std::erase_if(places, [](const PlaceRecord* place) { return place->rank->best > 1; });
    return places;
}

std::string ranking_sentence(const RankingRecord& ranking) {
    const std::string where = where_text(ranking), metric(aoscore::metric(ranking.metric).in_text);
    const Places ranked = ranked_places(ranking), leaders = leaders_of(ranking);
    if (ranked.empty()) return with_capital(where) + " no method for use was scored.";
    const PlaceRecord& best = *ranked.front();
    ClosestMethods closest{.leaders = {},
                           .ranked = ranked.size(),
                           .where = where,
                           .metric = metric,
                           .value = fixed_text(best.value, 4)};
    if (leaders.size() == 1) {
        closest.leaders.push_back(place_name(ranking, best));
        if (ranked.size() > 1) {
            const PlaceRecord& second = *ranked[1];
            if (const auto part = ratio(second.value - best.value, second.value))
                closest.value +=
                    fmt::format(", {} below that of {}", in_percent(*part), place_name(ranking, second));
        }
    } else {
        for (const PlaceRecord* place : leaders) closest.leaders.push_back(with_value(ranking, *place));
    }
    return closest_sentence(closest);
}

std::string bounds_sentence(const RankingRecord& ranking) {
    std::vector<std::string> bounds;
    for (const PlaceRecord& place : ranking.places) {
        if (!place.rank) bounds.push_back(with_value(ranking, place));
    }
    if (bounds.empty()) return "";
    const bool one = bounds.size() == 1;
    return fmt::format("{} {} not for use and {} no rank: {} how far one depth layer goes {}.",
                       listed(std::move(bounds)), one ? "is" : "are", one ? "has" : "have",
                       one ? "it shows" : "they show", where_text(ranking));
}

std::string cost_sentence(const Results& results, const RankingRecord& ranking) {
    const Places ranked = ranked_places(ranking);
    if (ranked.size() < 2 || ranking.view_keys.size() > 1) return "";
    const CellRecord* best = find_cell(results, ranked[0]->cell_ids.front());
    const CellRecord* second = find_cell(results, ranked[1]->cell_ids.front());
    if (best == nullptr || second == nullptr) return "";
    const std::string name = place_name(ranking, *ranked[0]), other = place_name(ranking, *ranked[1]);
    const auto times = ratio(cost_ms(*best), cost_ms(*second));
    const bool fetches = best->fetches_per_pixel && second->fetches_per_pixel;
    const std::string read =
        fetches ? fmt::format("{} texels a pixel, {} reads {}", fixed_text(best->fetches_per_pixel, 1), other,
                              fixed_text(second->fetches_per_pixel, 1))
                : "";
    if (!times) return fetches ? fmt::format("{} reads {}.", name, read) : "";
    const std::string time =
        fmt::format("{} takes {} times as long as {}", name, fixed_text(times, 2), other);
    return fetches ? fmt::format("{}. It reads {}.", time, read) : time + ".";
}

}  // namespace aoscore
