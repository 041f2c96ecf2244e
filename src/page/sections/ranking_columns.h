#pragma once

#include "page/section.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// One column of numbers of the ranking: its head, its decimals, and the source of a cell's number.
struct RankingColumn {
    std::string id;  ///< the metric's id; empty for costs and areas
    std::string label, unit, meaning;
    std::function<MeasuredMetric(const CellRecord&)> value;
    std::optional<int> decimals;  ///< empty: by the column's largest number
    int keep;                     ///< the lower, the longer a table that is too wide keeps it
};

inline constexpr int kKeepAreas = 3;  ///< RankingColumn::keep of the masks' areas
/// RankingColumn::keep of a metric's column.
int metric_keep(std::string_view id);

/// All metrics in the order of their table, then areas and costs.
std::vector<RankingColumn> ranking_columns(const Results& results);

}  // namespace aoscore
