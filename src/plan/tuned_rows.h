#pragma once

#include "plan/plan.h"

namespace aoscore {

/// Adds to every table of the plan the step from each row to the preset that its method's `default` was tuned
/// to, with as many taps as the row's preset takes and drawn for the table's radius. The cells come last
/// and are steps: they stand in no ranking, and change nothing that is measured of the others. Call it when
/// all else is planned.
void add_tuned_rows(ExperimentPlan& plan);

}  // namespace aoscore
