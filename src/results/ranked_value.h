#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The value of a metric; empty where it is missing.
std::optional<double> value_of(const MetricMap& metrics, const std::string& id);

/// The metric's value against the ranking's truth; also empty where the cell failed.
std::optional<double> ranked_value(const CellRecord& cell, const std::string& metric);

/// The id of the metric that ranks these cells: kRankingMetric where all that did not fail have it, else
/// kNoisyRankingMetric.
std::string ranking_metric(const std::vector<const CellRecord*>& cells);

}  // namespace aoscore
