#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace aoscore {

/// What the tuned presets bring a table's rows, whose cells stand in the order of the rows: whether tuning by
/// eye left much, in a sentence, and a row each with paired intervals. False where the table has none.
nlohmann::json tuned_rows_model(const TableRecord& table, const std::vector<const CellRecord*>& cells);

}  // namespace aoscore
