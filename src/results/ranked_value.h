#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The value of a metric; empty where it is missing or could not be had.
std::optional<double> value_of(const MetricMap& metrics, const std::string& id);

/// Its value against the ranking's truth; empty where the cell failed too.
std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric);

/// The id of the metric that ranks these cells: kRankingMetric where every one that did not fail has it, else
/// kNoisyRankingMetric.
std::string ranking_metric(const std::vector<const CellRecord*>& cells);

}  // namespace aoscore
