#pragma once

#include "plan/plan.h"
#include "screen/method/method.h"

#include <CLI/CLI.hpp>

#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// How methods are run, as the user asked for it: the same for every method of a score.
struct MethodOptions {
    std::string preset;                    ///< empty: those that each method is scored with
    std::string filter;                    ///< empty: the preset's own
    std::vector<std::string> assignments;  ///< "radius=0.5"
    bool own_parameters = false;           ///< lengths as descriptors have them, whatever the radius
    RunModes modes;
    std::set<std::string> chosen_modes;  ///< ids of the modes that the user named
    std::vector<std::string> signals;    ///< beside visibility: each for the methods that give it
};

/// --preset, --filter, --set, --own-parameters, and one option for each of run_mode_options().
void add_method_options(CLI::App& app, MethodOptions& options);

/// --signals.
void add_signals_option(CLI::App& app, std::vector<std::string>& signals);

/// The cells of each method: one for the preset that was asked for, or one for each that its descriptor
/// names; likewise for the modes of running, and what a descriptor changes there is said in `warnings`. An
/// assignment goes to the methods that have the parameter, and one of "filter.taps" to those whose filter has
/// it. Which methods give none of the signals is said too. Throws usage_error for an assignment that none of
/// them has, and for a signal that none gives, file_error for a descriptor's mode that does not exist.
std::vector<CellPlan> plan_cells(const std::vector<MethodDescriptor>& methods,
                                 const std::vector<MethodDescriptor>& filters, const MethodOptions& options,
                                 std::vector<std::string>& warnings);

}  // namespace aoscore
