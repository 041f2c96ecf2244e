#include "page/sections/place_name.h"

namespace aoscore {

std::string place_name(const RankingRecord& ranking, const PlaceRecord& place) {
    bool other_preset = false, other_filter = false;
    for (const PlaceRecord& other : ranking.places) {
        if (other.method_label != place.method_label) continue;
        other_preset |= other.preset != place.preset;
        other_filter |= other.preset == place.preset && other.filter != place.filter;
    }
    std::string name = place.method_label;
    if (other_preset) name += ", " + place.preset;
    if (other_filter) name += place.filter == "none" ? ", unfiltered" : ", " + place.filter;
    return name;
}

}  // namespace aoscore
