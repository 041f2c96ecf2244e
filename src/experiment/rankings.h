#pragma once

#include "results/results.h"

#include <vector>

namespace aoscore {

/// Orders the cells of every view and preset, and for every preset that was run on several views the methods
/// (with their filters) that succeeded on each of them. A tie is where the paired block bootstrap cannot tell
/// two cells apart. What Results::rankings holds. Cells without an analysis are left out, rankings without a
/// cell too.
std::vector<RankingRecord> rank(const std::vector<CellRecord>& cells, std::uint64_t seed);

}  // namespace aoscore
