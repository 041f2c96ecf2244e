#pragma once

#include "experiment/plan.h"
#include "results/results.h"
#include "scene/scene.h"

#include <filesystem>

namespace aoscore {

/// Runs the plan: for each view the truth, the G-buffer and every cell; writes images and results.json into
/// `folder`. A cell that fails becomes a failed row and the rest goes on. Throws before anything is written
/// when the plan names what does not exist or a scene that cannot be read; interrupted_error on Ctrl-C.
Results run_experiment(const ExperimentPlan& plan, const std::filesystem::path& folder);

/// Cells with an error.
std::size_t failed_cells(const Results& results);

/// The radius that a ranking uses for a view: the plan's, else the view's, else 2 % of the scene's diagonal
/// (said so in a warning). Metres.
double ranking_radius(const std::optional<double>& asked, const View& view, const Scene& scene,
                      std::vector<std::string>& warnings);

}  // namespace aoscore
