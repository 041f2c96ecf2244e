#pragma once

#include "results/results.h"

#include <functional>
#include <vector>

namespace aoscore {

/// Median and half the distance between the quartiles of the runs; both empty without runs.
Timing summarize(std::vector<double> runs_ms);

/// How many runs a thing deserves, judged by how long its warm-up run took: at least 10, or 3 when one takes
/// over a second.
int timed_runs(double warm_up_ms);

}  // namespace aoscore
