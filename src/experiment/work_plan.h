#pragma once

#include "experiment/view_run.h"

#include <optional>
#include <span>
#include <string>

namespace aoscore {

/// What a run has before it.
struct WorkPlan {
    std::size_t views = 0, views_known = 0;  ///< known: in the store
    std::size_t cells = 0, cells_known = 0;
    std::optional<double> seconds;  ///< estimated; empty where this machine has not measured before

    /// "80 cells on 2 views: 60 cells and 2 views measured before, 20 to do, about 3 min".
    std::string text() const;
    /// "2 more views, about 3 min": of what follows views that were needed to know.
    std::string rest_text() const;
};

WorkPlan plan_work(std::span<const ViewRun> runs, const ArtifactStore& store);

/// Whether everything that the run asks for is in the store.
bool is_known(const ViewRun& run, const ArtifactStore& store);

/// Whether all of its cells were scored before.
bool is_scored(const ViewRun& run, const ArtifactStore& store);

/// Remembers how long a view took on this machine, for the next estimate.
void learn_pace(const ArtifactStore& store, const ViewRun& run, const ViewOutcome& outcome, double seconds);

}  // namespace aoscore
