#pragma once

#include "plan/plan.h"

#include <CLI/CLI.hpp>

#include <string>

namespace aoscore {

/// The user's choice of an environment to light surfaces by.
struct EnvironmentOptions {
    std::string environment;  ///< "sky" or a file; empty: nothing is lit
    double turn_deg = 0;

    bool given() const { return !environment.empty(); }
};

/// Adds --environment and --environment-turn.
void add_environment_options(CLI::App& app, EnvironmentOptions& options);

/// Lights every cell of the view by the environment, if one was chosen. Throws as read_environment() does,
/// and usage_error for a turn of nothing. `warnings` says what light_cells() warns of.
void light_view(const EnvironmentOptions& options, const std::vector<MethodDescriptor>& methods,
                ViewPlan& view, std::vector<std::string>& warnings);

}  // namespace aoscore
