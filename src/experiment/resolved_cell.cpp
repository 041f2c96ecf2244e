#include "experiment/resolved_cell.h"

#include "experiment/own_truth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {

Registry load_registry(const std::filesystem::path& methods_dir, const std::vector<std::string>& asked,
                       std::vector<std::string>& warnings) {
    return {load_asked_methods(methods_dir, asked, warnings), load_filters(), load_fixed_pass(),
            load_lighting()};
}

Registry load_registry() {
    std::vector<std::string> none;
    return load_registry({}, {}, none);
}

namespace {

/// What the plan has otherwise than the preset, each as its name, `equals` and its value.
std::vector<std::string> changes_of(const CellPlan& plan, std::string_view equals) {
    std::vector<std::string> changes;
    const auto add = [&](const std::string& id, const nlohmann::json& value) {
        changes.push_back(
            fmt::format("{}{}{}", id, equals, value.is_string() ? value.get<std::string>() : value.dump()));
    };
    for (const auto& [id, value] : plan.overrides) add(id, value);
    for (const auto& [id, value] : plan.filter_overrides) add(std::string(kFilterPrefix) + id, value);
    for (const auto& [mode, choice] : unusual_modes(plan.modes)) add(mode, choice);
    return changes;
}

}  // namespace

std::string cell_name(const CellPlan& plan) {
    std::string name = plan.method + "/" + plan.preset;
    if (plan.filter) name += "/" + *plan.filter;
    const std::vector<std::string> changes = changes_of(plan, "=");
    if (!changes.empty()) name += fmt::format("/{}", fmt::join(changes, ","));
    return name;
}

std::string filter_of(const CellPlan& plan, const MethodDescriptor& method) {
    if (plan.filter) return *plan.filter;
    const auto own = method.preset_filters.find(plan.preset);
    return own == method.preset_filters.end() ? "none" : own->second;
}

std::string setting_text(const CellPlan& plan) {
    return fmt::format("{}", fmt::join(changes_of(plan, " "), ", "));
}

void light(MethodRequest& request, const MethodDescriptor& lighting) {
    request.lighting = &lighting;
    request.lighting_parameters = lighting.values("default");
}

ResolvedCell resolve(const CellPlan& plan, const Registry& registry, std::uint64_t seed) {
    ResolvedCell cell;
    cell.plan = plan;
    const MethodDescriptor& method = find_method(registry.methods, plan.method);
    cell.request.method = &method;
    cell.request.parameters = method.values(plan.preset, plan.overrides);
    cell.request.seed = seed;
    plan.modes.apply_to(cell.request);
    cell.filter = filter_of(plan, method);
    if (cell.filter != "none") {
        cell.request.filter = &find_method(registry.filters, cell.filter);
        cell.request.filter_parameters = cell.request.filter->values("default", plan.filter_overrides);
    }
    cell.own = own_truth(method, cell.request.parameters);
    return cell;
}

}  // namespace aoscore
