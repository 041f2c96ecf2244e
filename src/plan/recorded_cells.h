#pragma once

#include "jobs/recorded/recorded_view.h"
#include "plan/plan.h"
#include "screen/method/method.h"

#include <string>
#include <vector>

namespace aoscore {

/// Leaves out the cells that need more than a recorded frame holds, such as depth layers or a guard band,
/// which are drawn from a scene. `warnings` gets one sentence for each reason. No cell has a truth of its
/// own, since none can be traced.
void leave_out_cells(const RecordedView& view, const std::vector<MethodDescriptor>& methods,
                     std::vector<CellPlan>& cells, std::vector<std::string>& warnings);

}  // namespace aoscore
