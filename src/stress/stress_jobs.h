#pragma once

#include "jobs/job.h"
#include "jobs/view_keys.h"
#include "stress/stress_work.h"
#include "stress/unstressed.h"

#include <optional>
#include <vector>

namespace aoscore {

/// The jobs whose artifacts a stressed view's cells are made of.
struct SourceJobs {
    Job gbuffer, truth, contract;
    std::vector<Job> images;  ///< one for each request
};
SourceJobs source_jobs(const StressWork& work, const ViewKeys& keys);

/// The jobs of one stressed view.
struct StressJobs {
    JobGraph graph;
    Key setting, gbuffer_times;
    std::vector<Key> cells;                 ///< one for each request
    std::vector<std::optional<Key>> times;  ///< as many; empty where nothing is timed
};

/// Lays out the jobs; looks nothing up and makes nothing. Unstressed pictures come first, since one renderer
/// draws both.
StressJobs stress_jobs(const StressWork& work, const Unstressed& unstressed);

}  // namespace aoscore
