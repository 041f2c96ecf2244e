#pragma once

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace aoscore {

/// Model of the tables that give every measure with its 95 % interval, one for each ranking: per view, and
/// the means over views.
nlohmann::json interval_tables(const Results& results);

}  // namespace aoscore
