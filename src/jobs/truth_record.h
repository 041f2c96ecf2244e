#pragma once

#include "reference/truth.h"
#include "results/results.h"

namespace aoscore {

/// What a truth did not need to trace.
TruthSavings truth_savings(const Truth& truth);

/// Fills in what the results say about a view's truth: its cost and savings, its noise over the `valid`
/// pixels for each query, its causes. Channels are those of write_truth().
void record_truth(const Truth& truth, const Mask& valid, ViewRecord& view);

}  // namespace aoscore
