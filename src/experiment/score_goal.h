#pragma once

#include "experiment/view_run.h"
#include "plan/plan.h"
#include "results/results.h"

#include <optional>
#include <string_view>

namespace aoscore {

/// Half the width that the truth's noise may leave a metric's interval.
double allowed_noise(const ScoreGoal& goal, std::string_view metric);

/// The run with the rays that its goal took before, where the store remembers them.
ViewRun with_known_rays(const ViewRun& run, const ArtifactStore& store);

/// Measures a view with more and more rays, up to four times as many each time, until its goal is reached;
/// what was traced before is gone on from. Where every metric counts, a few cells find how many rays they
/// take before the others are scored. Throws usage_error where the goal would take more rays than a
/// pixel can have, or more than a day, as far as the first rays tell.
ViewOutcome run_to_goal(const ViewRun& run, const ArtifactStore& store);

}  // namespace aoscore
