#pragma once

#include "reference/truth.h"
#include "results/results.h"

#include <cstddef>

namespace aoscore {

/// What a truth did not need to trace.
TruthSavings truth_savings(const Truth& truth);

/// What the results say of query number `q`: its noise over the `valid` pixels.
TruthRecord query_record(const Truth& truth, std::size_t q, const Mask& valid);

/// Fills in what the results say about a view's truth: its cost and savings, its noise over the `valid`
/// pixels for each query, its causes. Channels are those of write_truth().
void record_truth(const Truth& truth, const Mask& valid, ViewRecord& view);

}  // namespace aoscore
