#include "page/ranking_order.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace aoscore {

Results in_ranking_order(Results results) {
    std::map<std::string, std::size_t> views, places;
    for (const ViewRecord& view : results.views) views.emplace(view.key, views.size());
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() != 1) continue;
        for (const PlaceRecord& place : ranking.places) places.emplace(place.cell_ids.front(), places.size());
    }
    const auto order_in = [](const std::map<std::string, std::size_t>& order, const std::string& id) {
        const auto found = order.find(id);
        return found == order.end() ? std::numeric_limits<std::size_t>::max() : found->second;
    };
    std::ranges::stable_sort(results.cells, {}, [&](const CellRecord& cell) {
        return std::pair(order_in(views, cell.view_key), order_in(places, cell.id));
    });
    return results;
}

}  // namespace aoscore
