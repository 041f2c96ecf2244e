#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace aoscore {

/// The model of tables with the 95 % interval of every measure, one for each ranking of a view or over views.
nlohmann::json interval_tables(const Results& results);

}  // namespace aoscore
