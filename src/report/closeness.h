#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The id of the metric that ranks these cells: rmse_debiased where every one that did not fail has it, else
/// rmse.
std::string ranking_metric(const std::vector<const CellRecord*>& cells);

/// Whether resampled parts of the picture turn round which of two cells of one view and preset is closer.
bool are_tied(const Results& results, const CellRecord& a, const CellRecord& b);

/// Its value in a cell; empty where it failed or has none.
std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric);

}  // namespace aoscore
