#pragma once

#include "experiment/plan.h"
#include "screen/method.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// How methods are run, as the user asked for it: the same for every method of a score.
struct MethodOptions {
    std::string preset = "default";
    std::string filter;                    ///< empty: the preset's own
    std::vector<std::string> assignments;  ///< "radius=0.5"
    RunModes modes;
};

/// --preset, --filter, --set, and one option for each of run_mode_options().
void add_method_options(CLI::App& app, MethodOptions& options);

/// One cell for each of the methods; an assignment goes to those that have the parameter. Throws usage_error
/// for an assignment that none of them has.
std::vector<CellPlan> plan_cells(const std::vector<MethodDescriptor>& methods, const MethodOptions& options);

}  // namespace aoscore
