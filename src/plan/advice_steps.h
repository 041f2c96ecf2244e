#pragma once

#include "plan/plan.h"
#include "plan/resolved_cell.h"

namespace aoscore {

/// Adds to the plan, for every cell of every view, the steps that advice measures from it: for each of
/// step_kinds() the changed cells, or why there is none. Steps are cells of the same view, so that truth and
/// G-buffer are shared. Bounds, few rays and images of folders have none.
void add_advice(ExperimentPlan& plan, const Registry& registry);

}  // namespace aoscore
