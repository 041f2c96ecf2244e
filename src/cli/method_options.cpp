#include "cli/method_options.h"

#include "cli/shared_options.h"
#include "core/error.h"
#include "core/known_names.h"
#include "experiment/resolved_cell.h"
#include "experiment/run_modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

std::pair<std::string, nlohmann::json> parse_assignment(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw usage_error("\"" + text + "\" is no assignment", "--set", "parameter=value");
    }
    const std::string value = text.substr(equals + 1);
    nlohmann::json parsed = nlohmann::json::parse(value, nullptr, false);
    // A word is a choice's name: --set exponent_form=text.
    if (parsed.is_discarded()) parsed = value;
    return {text.substr(0, equals), std::move(parsed)};
}

/// Whether the cell's method, or its filter, has the parameter; then it is set.
bool assign(const std::string& parameter, const nlohmann::json& value,
            const std::vector<MethodDescriptor>& methods, const std::vector<MethodDescriptor>& filters,
            CellPlan& cell) {
    const MethodDescriptor& method = find_method(methods, cell.method);
    if (!parameter.starts_with(kFilterPrefix)) {
        if (method.find_parameter(parameter) == nullptr) return false;
        cell.overrides[parameter] = value;
        return true;
    }
    const std::string id = parameter.substr(kFilterPrefix.size()), filter = filter_of(cell, method).filter;
    if (filter == "none" || find_method(filters, filter).find_parameter(id) == nullptr) return false;
    cell.filter_overrides[id] = value;
    return true;
}

/// Everything that can be assigned in any of the cells.
std::vector<std::string> parameters_of(const std::vector<CellPlan>& cells,
                                       const std::vector<MethodDescriptor>& methods,
                                       const std::vector<MethodDescriptor>& filters) {
    std::set<std::string> names;
    for (const CellPlan& cell : cells) {
        const MethodDescriptor& method = find_method(methods, cell.method);
        for (const Parameter& p : method.parameters) names.insert(p.id);
        const std::string filter = filter_of(cell, method).filter;
        if (filter == "none") continue;
        for (const Parameter& p : find_method(filters, filter).parameters)
            names.insert(std::string(kFilterPrefix) + p.id);
    }
    return {names.begin(), names.end()};
}

// The descriptor's choice of modes, where the user made none.
void add_modes_of(const MethodDescriptor& method, const MethodOptions& options, RunModes& modes,
                  std::vector<std::string>& warnings) {
    for (const auto& [id, choice] : method.scored.modes) {
        const auto& table = run_mode_options();
        const auto mode =
            std::find_if(table.begin(), table.end(), [&](const RunModeOption& m) { return m.id == id; });
        if (mode == table.end() ||
            std::find(mode->choices.begin(), mode->choices.end(), choice) == mode->choices.end()) {
            throw file_error(fmt::format("{} {} is no mode of running", id, choice),
                             (method.folder / "method.json").string() + ": scored.modes");
        }
        if (options.chosen_modes.contains(id)) continue;
        mode->choose(modes, choice);
        warnings.push_back(
            fmt::format("{} is drawn with {} {}, as its descriptor says for scores (--{} {} overrides)",
                        method.id, id, choice, id, mode->choices.front()));
    }
}

}  // namespace

void add_method_options(CLI::App& app, MethodOptions& options) {
    app.add_option("--preset", options.preset,
                   "Which preset of each method [those it is scored with, mostly default]");
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
            ->check(one_of(mode.choices));
    }
}

std::vector<CellPlan> plan_cells(const std::vector<MethodDescriptor>& methods,
                                 const std::vector<MethodDescriptor>& filters, const MethodOptions& options,
                                 std::vector<std::string>& warnings) {
    std::vector<CellPlan> cells;
    for (const MethodDescriptor& method : methods) {
        CellPlan cell;
        cell.method = method.id;
        if (!options.filter.empty()) cell.filter = options.filter;
        cell.modes = options.modes;
        add_modes_of(method, options, cell.modes, warnings);
        const std::vector<std::string> asked{options.preset};
        for (const std::string& preset : options.preset.empty() ? method.scored.presets : asked) {
            cell.preset = preset;
            cells.push_back(cell);
        }
    }
    for (const std::string& text : options.assignments) {
        const auto [parameter, value] = parse_assignment(text);
        bool taken = false;
        for (CellPlan& cell : cells) taken |= assign(parameter, value, methods, filters, cell);
        if (!taken) {
            throw unknown_name("no chosen method has a parameter", parameter,
                               parameters_of(cells, methods, filters), "--set " + text);
        }
    }
    return cells;
}

}  // namespace aoscore
