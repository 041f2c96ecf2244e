#pragma once

#include "cli/command.h"
#include "cli/outcome_options.h"
#include "core/error.h"
#include "plan/plan.h"

#include <filesystem>

namespace aoscore {

/// Runs the plan, makes the page, prints its path on standard output, and concludes: Outcome::conclude().
/// With --jobs or --job it does only that.
ExitCode run_and_page(ExperimentPlan plan, const std::filesystem::path& folder, const OutcomeOptions& options,
                      const GlobalOptions& global);

}  // namespace aoscore
