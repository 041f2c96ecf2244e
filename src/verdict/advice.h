#pragma once

#include "plan/plan.h"
#include "results/results.h"

#include <span>
#include <string>

namespace aoscore {

/// Judges the steps from one cell. `ids` are those of the cells of its view, in the order of the plan's;
/// all of them must be among the results. Errors are compared by paired resampling of blocks, simultaneously
/// for all steps. Steps that change no pixel become skipped ones. The best buy comes first: steps that are
/// surely closer and take no more time in the median, by the error that they take off; those that take
/// some, by the error that a millisecond takes off; those whose cost is not known; ties; those that are
/// surely farther. Costs are processor time of all threads where every run has it, else the clock's.
AdviceRecord judge_advice(const AdvicePlan& plan, std::span<const std::string> ids, const Results& results);

}  // namespace aoscore
