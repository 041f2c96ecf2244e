#pragma once

#include "experiment/view_run.h"

#include <optional>
#include <span>
#include <string>

namespace aoscore {

/// The work that a run has to do.
struct WorkPlan {
    std::size_t views = 0, views_known = 0;  ///< known: in the store
    std::size_t cells = 0, cells_known = 0;
    std::optional<double> seconds;  ///< estimated; empty where this machine has not measured before

    /// The work in words: "80 cells on 2 views: 60 cells and 2 views measured before, 20 to do, about 3 min".
    std::string text() const;
    /// The remaining work after the views that the estimate needed: "2 more views, about 3 min".
    std::string rest_text() const;
};

WorkPlan plan_work(std::span<const ViewRun> runs, const ArtifactStore& store);

/// Whether everything that the run asks for is in the store.
bool is_known(const ViewRun& run, const ArtifactStore& store);

/// Whether all of the run's cells were scored before.
bool is_scored(const ViewRun& run, const ArtifactStore& store);

/// Stores the time that a view took on this machine, for the next estimate.
void learn_pace(const ArtifactStore& store, const ViewRun& run, const ViewOutcome& outcome, double seconds);

}  // namespace aoscore
