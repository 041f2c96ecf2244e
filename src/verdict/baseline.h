#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// Compares every cell of a run with its cell in an earlier one. They are comparable where scene, camera,
/// size, radius and mask are the same; the paired block bootstrap tells whether they differ, for all cells
/// together (see simultaneous_intervals()).
BaselineRecord against_baseline(const Results& now, const Results& before);

/// Says so where another version of the ray tracer made the earlier run's truths: what changed may then be
/// the truth, or the error that it states. Empty where the same did.
std::string other_truths(const Results& now, const Results& before);

}  // namespace aoscore
