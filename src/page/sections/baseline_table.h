#pragma once

#include "page/section.h"

namespace aoscore {

/// Compares the cells of this run with those of the baseline, as part of the ranking's model: a list of one
/// table, or empty without a baseline.
nlohmann::json baseline_tables(const Results& results);

}  // namespace aoscore
