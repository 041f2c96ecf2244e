#pragma once

#include "reference/truth.h"
#include "results/results.h"

#include <cstddef>

namespace aoscore {

/// The rays that a truth did not need to trace.
TruthSavings truth_savings(const Truth& truth);

/// The record of query number `q` in the results, with its noise over the `valid` pixels.
TruthRecord query_record(const Truth& truth, std::size_t q, const Mask& valid);

/// Records a view's truth in the results: its cost and savings, its noise over the `valid` pixels for each
/// query, its causes. Channels are those of write_truth().
void record_truth(const Truth& truth, const Mask& valid, ViewRecord& view);

}  // namespace aoscore
