#include "cli/method_options.h"

#include "core/error.h"
#include "experiment/run_modes.h"

#include <map>
#include <utility>

namespace aoscore {
namespace {

template <class Value>
void add_choice(CLI::App& app, const char* name, Value& value, const std::map<std::string, Value>& choices,
                const char* meaning) {
    std::vector<std::string> names;
    for (const auto& [choice, meant] : choices) names.push_back(choice);
    app.add_option_function<std::string>(
           name, [&value, &choices](const std::string& choice) { value = choices.at(choice); }, meaning)
        ->check(CLI::IsMember(names));
}

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
    add_choice(app, "--border", options.border, border_names(),
               "What a tap outside of the picture reads: the far plane, or the nearest pixel [far]");
    add_choice(app, "--normals", options.normals, normals_names(), "Where normals come from [as-described]");
    add_choice(app, "--resolution", options.resolution, resolution_names(),
               "Which pixels are shaded, from which G-buffer [full]");
}

std::vector<CellPlan> plan_cells(const std::vector<MethodDescriptor>& methods, const MethodOptions& options) {
    std::vector<CellPlan> cells;
    for (const MethodDescriptor& method : methods) {
        CellPlan cell;
        cell.method = method.id;
        cell.preset = options.preset;
        if (!options.filter.empty()) cell.filter = options.filter;
        cell.border = options.border;
        cell.normals = options.normals;
        cell.resolution = options.resolution;
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
