#pragma once

#include "plan/plan.h"
#include "results/results.h"

#include <filesystem>
#include <functional>

namespace aoscore {

/// Runs the plan: for each view the truth, the G-buffer and every cell; images and results.json appear in
/// `folder` all at once when everything is done: a run that is stopped leaves the earlier content. `finish`,
/// when given, is called with the folder in which the results are staged, to add to them (the page). Where
/// the plan asks for a first answer that was measured before, nothing is done, since the whole plan can
/// follow at once. A cell that fails becomes a failed row and the rest goes on. Throws before anything is
/// written when the plan has an unknown name or a scene that cannot be read; interrupted_error on Ctrl-C.
Results run_experiment(const ExperimentPlan& plan, const std::filesystem::path& folder,
                       const std::function<void(const std::filesystem::path&)>& finish = {});

/// The number of cells with an error.
std::size_t failed_cells(const Results& results);

}  // namespace aoscore
