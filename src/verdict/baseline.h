#pragma once

#include "results/results.h"

namespace aoscore {

/// Compares every cell of a run with its cell in an earlier one. They are comparable where scene, camera,
/// size, radius and mask are the same; the paired block bootstrap tells whether they differ, for all cells
/// together (see simultaneous_intervals()).
BaselineRecord against_baseline(const Results& now, const Results& before);

}  // namespace aoscore
