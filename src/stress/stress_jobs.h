#pragma once

#include "jobs/job.h"
#include "jobs/view_keys.h"
#include "stress/stress_work.h"
#include "stress/unstressed.h"

#include <vector>

namespace aoscore {

/// What a stressed view's cells are made of.
struct SourceJobs {
    Job gbuffer, truth, contract;
    std::vector<Job> images;  ///< one a request
};
SourceJobs source_jobs(const StressWork& work, const ViewKeys& keys);

/// The jobs of one stressed view.
struct StressJobs {
    JobGraph graph;
    Key setting;
    std::vector<Key> cells;  ///< one a request
};

/// Lays out the jobs; looks nothing up and makes nothing. What is unstressed comes first, since one renderer
/// draws both.
StressJobs stress_jobs(const StressWork& work, const Unstressed& unstressed);

}  // namespace aoscore
