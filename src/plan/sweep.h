#pragma once

#include "plan/assignment.h"
#include "plan/plan.h"
#include "plan/resolved_cell.h"

#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// One axis of a sweep: a parameter of methods ("samples"), a parameter of filters ("filter.weights"), a run
/// mode ("resolution"), "preset", "filter", or the picture's "size" ("640x360").
struct SweepAxis {
    std::string id;
    std::vector<ParameterValue> values;
};

/// Methods over the product of axes.
struct SweepRequest {
    std::vector<std::string> methods;
    CellPlan base;                ///< preset, filter and modes where they are not varied
    std::vector<Assignment> set;  ///< set where a method or its filter has the parameter
    std::vector<SweepAxis> axes;
};

/// Reads "samples=4,8,16". A value is a number, true, false, or a word. Throws usage_error for another form.
SweepAxis parse_axis(const std::string& text);

/// Adds to the plan, on views like `view` (one for each size on the axes, or as it is), every cell that the
/// request stands for, and the sweep of them. A cell that the plan has already is not added twice. An axis
/// that a method or its filter does not declare is left out for that method, as is a preset that it lacks;
/// the sweep's notes say so. Throws usage_error for an axis, or a parameter that is set, which nothing in the
/// sweep declares (listing what there is), for a parameter that is set and varied, for a value out of its
/// range, and for an unknown method or filter.
void add_sweep(ExperimentPlan& plan, const ViewPlan& view, const SweepRequest& request, SweepPlan& sweep,
               const Registry& registry);

}  // namespace aoscore
