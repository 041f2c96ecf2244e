#include "report/closeness.h"

#include <algorithm>

namespace aoscore {
bool are_tied(const Results& results, const CellRecord& a, const CellRecord& b) {
    const auto place_of = [](const RankingRecord& ranking, const CellRecord& cell) {
        return std::ranges::find(ranking.places, std::vector<std::string>{cell.id}, &PlaceRecord::cell_ids);
    };
    return std::ranges::any_of(results.rankings, [&](const RankingRecord& ranking) {
        const auto first = place_of(ranking, a), second = place_of(ranking, b);
        if (first == ranking.places.end() || second == ranking.places.end()) return false;
        const auto index = static_cast<std::size_t>(second - ranking.places.begin());
        return std::ranges::find(first->ties, index) != first->ties.end();
    });
}

std::string ranking_metric(const std::vector<const CellRecord*>& cells) {
    const bool debiased = std::all_of(cells.begin(), cells.end(), [](const CellRecord* cell) {
        return !cell->error.empty() || ranked_value(*cell, "rmse_debiased").has_value();
    });
    return debiased ? "rmse_debiased" : "rmse";
}

std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric) {
    if (!cell.error.empty()) return std::nullopt;
    const auto found = cell.ranked.find(metric);
    return found == cell.ranked.end() ? std::nullopt : found->second.value;
}

}  // namespace aoscore
