#pragma once

#include "jobs/job.h"
#include "jobs/view_work.h"

namespace aoscore {

/// What a job of a view is likely to take, in seconds of two cores at 3 GHz with everything that it needs at
/// hand. Only the ratios matter: parts of a plan are made even by them.
double estimated_cost_s(const Job& job, const ViewWork& work);

}  // namespace aoscore
