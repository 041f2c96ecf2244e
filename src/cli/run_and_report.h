#pragma once

#include "core/error.h"
#include "experiment/plan.h"

#include <filesystem>

namespace aoscore {

/// Runs the plan, makes the page, and prints its path on standard output. cells_failed when a cell failed.
ExitCode run_and_report(const ExperimentPlan& plan, const std::filesystem::path& folder);

}  // namespace aoscore
