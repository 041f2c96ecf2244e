#pragma once

#include "results/results.h"

#include <vector>

namespace aoscore {

/// Makes Results::rankings. On every view all cells that succeeded are compared with each other, whatever
/// their presets, settings and filters: they have the same G-buffer and truth. There is also a ranking over
/// each group of comparable_views(), of the cells that succeeded on all of its views, unless there are none.
/// Ranks come from the paired block bootstrap; bounds have a place but no rank. Cells without an analysis and
/// views without a cell are left out. Throws internal_error for a cell of a view that is not among `views`.
std::vector<RankingRecord> rank(const std::vector<ViewRecord>& views, const std::vector<CellRecord>& cells,
                                std::uint64_t seed);

/// The results, ranked where they were read without rankings because those of their schema followed other
/// rules (see results/upgrade/).
Results ranked_anew(Results results);

}  // namespace aoscore
