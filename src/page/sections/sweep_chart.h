#pragma once

#include "results/sweep_rows.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <vector>

namespace aoscore {

/// The points of one view for the script's chart of error over cost. A line joins settings that differ by
/// numbers alone; where these are too many lines, all of a method.
nlohmann::json sweep_chart(const std::vector<const SweepRow*>& rows, std::optional<double> budget_ms);

}  // namespace aoscore
