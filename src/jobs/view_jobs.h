#pragma once

#include "jobs/job.h"
#include "jobs/view_work.h"

#include <optional>
#include <vector>

namespace aoscore {

/// Where the artifacts of one cell are found.
struct CellKeys {
    Key image, score;
    std::optional<Key> own_score;
    std::optional<Key> fetches, times;  ///< empty for a contestant without a cost
};

/// The jobs of one view: what its results need, and what that is made of.
struct ViewJobs {
    JobGraph graph;
    Key view;
    std::optional<Key> gbuffer_times, truth_file, gbuffer_file;
    std::vector<CellKeys> cells;  ///< in the order of the work's
};

/// Which of a view's artifacts a contestant's image is made of.
std::vector<Key> image_sources(const Contestant& contestant, const Key& gbuffer, const Key& truth);

/// Lays out the jobs; looks nothing up and makes nothing.
ViewJobs view_jobs(const ViewWork& work);

}  // namespace aoscore
