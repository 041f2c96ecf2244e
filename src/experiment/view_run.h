#pragma once

#include "jobs/view_jobs.h"
#include "jobs/view_work.h"
#include "plan/ranking_radius.h"
#include "plan/resolved_cell.h"
#include "results/results.h"
#include "store/artifact_store.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One view of a plan with all names looked up.
struct ViewRun {
    const ViewPlan& plan;
    RankingRadius radius;
    std::optional<double> drawn_for_m;  ///< AO radius that lengths follow; empty: descriptors' own lengths
    std::vector<ResolvedCell> cells;    ///< one for each of the work's cells
    ParameterValues lighting_parameters = {};  ///< empty where frames are not lit
    std::string lighting = {};                 ///< label of the pass; empty where frames are not lit
    ViewWork work;
    ViewJobs jobs;
};

/// The record of the view before anything is measured.
ViewRecord described_view(const ViewRun& run);

struct ViewOutcome {
    ViewRecord view;
    std::vector<CellRecord> cells;  ///< in the order of ViewRun::cells
    std::uint64_t rays = 0;         ///< rays traced now
    std::size_t measured = 0;       ///< cells that were scored now
    /// The largest half width that the noise of own truths gives the ranking metric.
    double own_noise = 0;
};

/// Takes artifacts from the store, and makes the rest: truth, G-buffer, every cell's image and scores; times
/// come last, round by round over the cells, so that a disturbance of the machine affects all of them. Each
/// artifact is stored as soon as it is made: an interrupted run continues where it stopped.
ViewOutcome run_view(const ViewRun& run, const ArtifactStore& store);

}  // namespace aoscore
