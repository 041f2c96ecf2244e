#pragma once

#include "page/section.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One column of numbers of the ranking: its head, how wide its digits run, and where a cell's number comes
/// from.
struct RankingColumn {
    std::string id;  ///< of the metric; empty for costs and areas
    std::string label, unit, meaning;
    std::function<MeasuredMetric(const CellRecord&)> value;
    std::optional<int> decimals;  ///< empty: as the column's largest number asks
};

/// All metrics in the order of their table, then areas and costs.
std::vector<RankingColumn> ranking_columns(const Results& results);

}  // namespace aoscore
