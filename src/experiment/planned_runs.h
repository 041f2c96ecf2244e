#pragma once

#include "experiment/view_run.h"
#include "jobs/scene_tools.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace aoscore {

/// One picture to measure, with all names of its plan looked up.
struct PreparedView {
    const ViewPlan* plan;
    std::size_t plan_index;  ///< index into ExperimentPlan::views
    std::string key;         ///< its key in the results: "atrium/wide", with its size where that is taken
    std::shared_ptr<const Scene> scene;
    View view;
    RankingRadius radius;
    std::vector<ResolvedCell> cells;
};

/// A plan's views with their jobs, laid out but not begun.
class PlannedRuns {
  public:
    /// Loads every scene and looks up all names before any work is done or file is written, so that a wrong
    /// name costs nothing. `plan` and `store` must outlive it. Throws usage_error and file_error for names
    /// that do not exist.
    PlannedRuns(const ExperimentPlan& plan, const ArtifactStore& store);

    /// Lays out the jobs; images go below `folder`.
    void lay_out(const std::filesystem::path& folder);

    const Registry& registry() const { return registry_; }
    SceneTools& tools() { return tools_; }
    const std::vector<PreparedView>& prepared() const { return prepared_; }
    const std::vector<ViewRun>& runs() const { return runs_; }  ///< one for each prepared view

  private:
    const ExperimentPlan& plan_;
    const ArtifactStore& store_;
    Registry registry_;
    std::vector<PreparedView> prepared_;
    SceneTools tools_;
    std::vector<ViewRun> runs_;
};

}  // namespace aoscore
