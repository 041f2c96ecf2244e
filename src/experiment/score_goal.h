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

/// Measures a view with more and more rays, the same for all pixels, up to four times as many each time,
/// until its goal is reached; what was traced before is gone on from. Where every metric counts, a few cells
/// find how many rays they take before the others are scored. Throws usage_error where the goal would take
/// more rays than a pixel can have, or more than a day, as far as the first rays tell.
///
/// Were rays given out by tiles for what they are worth to the differences that rank, 0.61 (atrium/wide),
/// 0.74 (cathedral/nave) and 0.51 (railing/front) of them would do, and 0.72, 0.81 and 0.61 where every pixel
/// has its first 16 (nine cells, 640x360, the variance of all pairs' differences, tiles' worth known
/// beforehand). That is not done: these views take 32, 32 and 64 rays a pixel, less than a tenth of a run's
/// time.
ViewOutcome run_to_goal(const ViewRun& run, const ArtifactStore& store);

}  // namespace aoscore
