#pragma once

#include "jobs/job.h"
#include "jobs/view_work.h"

#include <optional>
#include <vector>

namespace aoscore {

/// The keys of one cell's artifacts.
struct CellKeys {
    Key image, score;
    std::optional<Key> light, lit_file;  ///< empty where it is not lit
    std::optional<Key> own_score;
    std::optional<Key> fetches, times;  ///< empty for a contestant without a cost
    std::optional<Key> repeats;         ///< empty where they are not asked for, or nothing is drawn
};

/// The jobs of one view: those that its results need, and their inputs.
struct ViewJobs {
    JobGraph graph;
    Key view;
    std::optional<Key> gbuffer_times, truth_file, gbuffer_file;
    std::optional<Key> irradiance, view_light;  ///< empty where nothing is lit
    std::vector<CellKeys> cells;                ///< in the order of the work's cells
};

/// The keys of a view's artifacts that a contestant's image is made of.
std::vector<Key> image_sources(const Contestant& contestant, const Key& gbuffer, const Key& truth);

/// Lays out the jobs; looks nothing up and makes nothing.
ViewJobs view_jobs(const ViewWork& work);

}  // namespace aoscore
