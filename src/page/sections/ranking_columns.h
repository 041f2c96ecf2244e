#pragma once

#include "page/section.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One column of numbers of the ranking: its head, its decimals, and the source of a cell's number.
struct RankingColumn {
    std::string id;  ///< the metric's id; empty for costs and areas
    std::string label, unit, meaning;
    std::function<MeasuredMetric(const CellRecord&)> value;
    std::optional<int> decimals;  ///< empty: by the column's largest number
};

/// All metrics in the order of their table, then areas and costs.
std::vector<RankingColumn> ranking_columns(const Results& results);

}  // namespace aoscore
