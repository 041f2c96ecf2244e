#include "cli/method_options.h"

#include "core/error.h"
#include "experiment/run_modes.h"

#include <fmt/format.h>

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

}  // namespace

void add_method_options(CLI::App& app, MethodOptions& options) {
    app.add_option("--preset", options.preset, "Which preset of each method")->capture_default_str();
    app.add_option("--filter", options.filter, "A filter (see list methods), or none [the preset's own]");
    app.add_option("--set", options.assignments,
                   "A parameter of the methods that have it, over the preset: radius=0.5");
    for (const RunModeOption& mode : run_mode_options()) {
        app.add_option_function<std::string>(
               fmt::format("--{}", mode.id),
               [&options, &mode](const std::string& choice) { mode.choose(options.modes, choice); },
               fmt::format("{} [{}]", mode.meaning, mode.choices.front()))
            ->check(CLI::IsMember(mode.choices));
    }
}

std::vector<CellPlan> plan_cells(const std::vector<MethodDescriptor>& methods, const MethodOptions& options) {
    std::vector<CellPlan> cells;
    for (const MethodDescriptor& method : methods) {
        CellPlan cell;
        cell.method = method.id;
        cell.preset = options.preset;
        if (!options.filter.empty()) cell.filter = options.filter;
        cell.modes = options.modes;
        cells.push_back(std::move(cell));
    }
    for (const std::string& text : options.assignments) {
        const auto [parameter, value] = parse_assignment(text);
        bool taken = false;
        for (std::size_t i = 0; i < methods.size(); ++i) {
            if (methods[i].find_parameter(parameter) == nullptr) continue;
            cells[i].overrides[parameter] = value;
            taken = true;
        }
        if (!taken) throw usage_error("no chosen method has a parameter " + parameter, "--set " + text);
    }
    return cells;
}

}  // namespace aoscore
