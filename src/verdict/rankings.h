#pragma once

#include "results/results.h"

#include <vector>

namespace aoscore {

/// What Results::rankings holds. On every view all cells that succeeded are compared with each other,
/// whatever their presets, settings and filters: they were drawn from one G-buffer and are held against one
/// truth. So are, over each group of comparable_views(), those that succeeded on every view of the group;
/// there is no such ranking where none did. Ranks are those of Ranks, by the paired block bootstrap; bounds
/// have a place but no rank. Cells without an analysis are left out, views without a cell too. Throws
/// internal_error for a cell of a view that is not among `views`.
std::vector<RankingRecord> rank(const std::vector<ViewRecord>& views, const std::vector<CellRecord>& cells,
                                std::uint64_t seed);

}  // namespace aoscore
