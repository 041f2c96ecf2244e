#include "report/place_name.h"

#include <algorithm>

namespace aoscore {

std::string place_name(const RankingRecord& ranking, const PlaceRecord& place) {
    const auto another = [&](std::string PlaceRecord::*what) {
        return std::ranges::any_of(ranking.places, [&](const PlaceRecord& other) {
            return other.method_label == place.method_label && other.*what != place.*what;
        });
    };
    std::string name = place.method_label;
    if (another(&PlaceRecord::preset)) name += ", " + place.preset;
    if (another(&PlaceRecord::filter)) name += place.filter == "none" ? ", unfiltered" : ", " + place.filter;
    return name;
}

}  // namespace aoscore
