#pragma once

#include "page/section.h"

namespace aoscore {

/// The cells of this run against those of the baseline, as the ranking's model: a list of one table, or empty
/// without a baseline.
nlohmann::json baseline_tables(const Results& results);

}  // namespace aoscore
