#include "cli/method_options.h"

#include "cli/shared_options.h"
#include "core/error.h"
#include "core/known_names.h"
#include "core/signal.h"
#include "plan/assignment.h"
#include "plan/run_modes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

std::vector<std::string> methods_that_give(const std::string& id) {
    std::vector<std::string> ids;
    for (const MethodDescriptor& method : load_methods()) {
        if (method.gives(id)) ids.push_back(method.id);
    }
    return ids;
}

// Sets the modes: the user's choice overrides the descriptor's for scores.
void choose_modes(const MethodDescriptor& method, const MethodOptions& options, RunModes& modes,
                  std::vector<std::string>& warnings) {
    for (const RunModeOption& mode : run_mode_options()) {
        const auto scored = method.scored.modes.find(std::string(mode.id));
        if (options.chosen_modes.contains(std::string(mode.id))) {
            mode.choose(modes, mode.chosen(options.modes));
        } else if (scored != method.scored.modes.end()) {
            warnings.push_back(
                fmt::format("{} is drawn with {} {}, as its descriptor says for scores (--{} {} overrides)",
                            method.id, mode.id, scored->second, mode.id, mode.choices.front()));
        }
    }
}

// Adds each signal that was asked for to the methods that give it.
void add_signals(const std::vector<MethodDescriptor>& methods, const std::vector<std::string>& signals,
                 std::vector<CellPlan>& cells, std::vector<std::string>& warnings) {
    for (const std::string& id : signals) {
        std::vector<std::string> without;
        for (const MethodDescriptor& method : methods) {
            if (!method.gives(id)) without.push_back(method.id);
        }
        if (without.size() == methods.size()) {
            throw usage_error("no chosen method gives it", "--signals " + id,
                              fmt::format("with one of {}", fmt::join(methods_that_give(id), ", ")));
        }
        if (!without.empty()) {
            warnings.push_back(fmt::format("no {} is scored of {}, which {} not give it", id,
                                           fmt::join(without, ", "), without.size() == 1 ? "does" : "do"));
        }
        for (CellPlan& cell : cells) {
            if (find_method(methods, cell.method).gives(id)) cell.signals.push_back(id);
        }
    }
}

}  // namespace

void add_signals_option(CLI::App& app, std::vector<std::string>& signals) {
    app.add_option("--signals", signals,
                   fmt::format("Also score these of the methods that give them: {}",
                               fmt::join(further_signals(), ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(further_signals()));
}

void add_method_options(CLI::App& app, MethodOptions& options) {
    app.add_option("--preset", options.preset,
                   "Which preset of each method, or a file of presets for one, as tune writes it [those it "
                   "is scored with, mostly default]");
    app.add_option("--filter", options.filter, "A filter (see list methods), or none [the preset's own]");
    app.add_option(
           "--set", options.assignments,
           "A parameter of the methods that have it, over the preset: radius=0.5; or of their filters: "
           "filter.taps=5")
        ->allow_extra_args(false);
    app.add_flag(
        "--own-parameters", options.own_parameters,
        "Leave the lengths of methods and filters as their descriptors have them, whatever the radius "
        "[drawn for it]");
    for (const RunModeOption& mode : run_mode_options()) {
        app.add_option_function<std::string>(
               fmt::format("--{}", mode.id),
               [&options, &mode](const std::string& choice) {
                   mode.choose(options.modes, choice);
                   options.chosen_modes.emplace(mode.id);
               },
               fmt::format("{} [{}]", mode.meaning, mode.choices.front()))
            ->type_name(fmt::format("{{{}}}", fmt::join(mode.choices, ",")));
    }
}

std::vector<std::filesystem::path> MethodOptions::preset_files() const {
    if (!preset.ends_with(".json")) return {};
    return {preset};
}

std::vector<CellPlan> plan_cells(std::vector<MethodDescriptor>& methods,
                                 const std::vector<MethodDescriptor>& filters, const MethodOptions& options,
                                 std::vector<std::string>& warnings) {
    std::map<std::string, std::vector<std::string>> added;
    for (const std::filesystem::path& file : options.preset_files()) {
        AddedPresets presets = add_presets(methods, file);
        added[presets.method] = std::move(presets.presets);
    }
    std::vector<CellPlan> cells;
    for (const MethodDescriptor& method : methods) {
        std::vector<CellPlan> scored = scored_cells(method);
        std::vector<std::string> presets;
        if (added.contains(method.id)) {
            presets = added.at(method.id);
        } else if (added.empty() && !options.preset.empty()) {
            presets = {options.preset};
        }
        if (!presets.empty()) scored.assign(presets.size(), scored.front());
        for (std::size_t i = 0; i < presets.size(); ++i) scored[i].preset = presets[i];
        RunModes modes = scored.front().modes;
        choose_modes(method, options, modes, warnings);
        for (CellPlan& cell : scored) {
            cell.modes = modes;
            if (!options.filter.empty()) cell.filter = options.filter;
            cells.push_back(std::move(cell));
        }
    }
    add_signals(methods, options.signals, cells, warnings);
    for (const std::string& text : options.assignments) {
        const Assignment assignment = parse_assignment(text);
        bool taken = false;
        for (CellPlan& cell : cells) taken |= assign(assignment, methods, filters, cell);
        if (!taken) {
            throw unknown_name("no chosen method has a parameter", assignment.parameter,
                               assignable_parameters(cells, methods, filters), "--set " + text);
        }
    }
    return cells;
}

}  // namespace aoscore
