#pragma once

#include "cli/command.h"
#include "cli/outcome_options.h"
#include "core/error.h"
#include "plan/plan.h"

#include <filesystem>
#include <functional>

namespace aoscore {

/// Runs the plan, makes the page, prints its path on standard output, calls `finish` with the results, where
/// it is given, and concludes: Outcome::conclude(). With --jobs or --job it does only that.
ExitCode run_and_page(ExperimentPlan plan, const std::filesystem::path& folder, const OutcomeOptions& options,
                      const GlobalOptions& global, const std::function<void(const Results&)>& finish = {});

}  // namespace aoscore
