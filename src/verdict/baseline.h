#pragma once

#include "results/results.h"

namespace aoscore {

/// Holds every cell of a run against the cell of the same id in an earlier one. They are comparable where
/// scene, camera, size, radius and mask are the same; whether they differ is told by the paired block
/// bootstrap, for all cells together (see simultaneous_intervals()).
BaselineRecord against_baseline(const Results& now, const Results& before);

}  // namespace aoscore
