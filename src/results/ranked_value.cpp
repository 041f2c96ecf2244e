#include "results/ranked_value.h"

#include "metrics/roles.h"

#include <algorithm>

namespace aoscore {

std::optional<double> value_of(const MetricMap& metrics, const std::string& id) {
    const auto found = metrics.find(id);
    return found == metrics.end() ? std::nullopt : found->second.value;
}

std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric) {
    return cell.error.empty() ? value_of(cell.ranked, metric) : std::nullopt;
}

std::string ranking_metric(const std::vector<const CellRecord*>& cells) {
    const bool debiased = std::ranges::all_of(cells, [](const CellRecord* cell) {
        return !cell->error.empty() || value_of(cell->ranked, kRankingMetric).has_value();
    });
    return debiased ? kRankingMetric : kNoisyRankingMetric;
}

}  // namespace aoscore
