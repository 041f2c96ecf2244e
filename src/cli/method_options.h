#pragma once

#include "plan/plan.h"
#include "screen/method/method.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The user's options for running methods, the same for every method of a score.
struct MethodOptions {
    /// The id of a preset, or a file of presets; empty: those that each descriptor names for scores.
    std::string preset;
    std::string filter;                    ///< empty: the preset's own
    std::vector<std::string> assignments;  ///< "radius=0.5"
    bool own_parameters = false;           ///< methods keep their descriptors' lengths
    RunModes modes;
    std::set<std::string> chosen_modes;  ///< ids of the modes that the user named
    std::vector<std::string> signals;    ///< signals beside visibility, for the methods that give them

    /// The files of presets: one or none.
    std::vector<std::filesystem::path> preset_files() const;
};

/// Adds --preset, --filter, --set, --own-parameters, and one option for each of run_mode_options().
void add_method_options(CLI::App& app, MethodOptions& options);

/// Adds --signals.
void add_signals_option(CLI::App& app, std::vector<std::string>& signals);

/// Makes the cells of each method: one for the preset that was asked for, one for each that the file of
/// presets, which is added to `methods`, or its descriptor names. Modes are chosen likewise, and `warnings`
/// says which the descriptor changes. An assignment goes to the methods that have the parameter, and one of
/// "filter.taps" to those whose filter has it. `warnings` also name methods that give none of the signals.
/// Throws usage_error for an assignment that none of the methods has, and for a signal that none gives,
/// file_error for a descriptor's mode that does not exist.
std::vector<CellPlan> plan_cells(std::vector<MethodDescriptor>& methods,
                                 const std::vector<MethodDescriptor>& filters, const MethodOptions& options,
                                 std::vector<std::string>& warnings);

}  // namespace aoscore
