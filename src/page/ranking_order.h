#pragma once

#include "results/results.h"

namespace aoscore {

/// The results with the cells of each view in the order of its ranking, best first; those without a place,
/// which failed, come last in the order they had.
Results in_ranking_order(Results results);

}  // namespace aoscore
