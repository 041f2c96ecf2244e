#include "plan/resolved_cell.h"

#include "core/known_names.h"
#include "jobs/contest/command_image.h"
#include "jobs/contest/few_rays.h"
#include "jobs/contest/folder_image.h"
#include "jobs/own_truth.h"
#include "plan/lit_cells.h"
#include "screen/method/lengths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace aoscore {

Registry load_registry(const std::filesystem::path& methods_dir, const std::vector<std::string>& asked,
                       std::vector<std::string>& warnings) {
    return {load_asked_methods(methods_dir, asked, warnings),
            load_filters(),
            load_fixed_pass(),
            load_lighting(),
            few_rays_descriptor(),
            {}};
}

Registry load_registry() {
    std::vector<std::string> none;
    return load_registry({}, {}, none);
}

namespace {

/// The plan's changes of the preset, each as its name, `equals` and its value.
std::vector<std::string> changes_of(const CellPlan& plan, std::string_view equals) {
    std::vector<std::string> changes;
    const auto add = [&](const std::string& id, const ParameterValue& value) {
        changes.push_back(fmt::format("{}{}{}", id, equals, value.text()));
    };
    for (const auto& [id, value] : plan.overrides) add(id, value);
    for (const auto& [id, value] : plan.filter_overrides) add(std::string(kFilterPrefix) + id, value);
    for (const auto& [mode, choice] : unusual_modes(plan.modes)) add(mode, choice);
    if (plan.radius_factor != 1) add("radius-factor", plan.radius_factor);
    if (plan.draw != 0) add("draw", plan.draw);
    return changes;
}

void add_lengths(const MethodDescriptor& owner, const ParameterValues& values,
                 const ParameterValues& overrides, const char* origin, std::string_view prefix,
                 std::vector<LengthRecord>& lengths) {
    for (const Parameter& p : owner.parameters) {
        if (p.length_power == 0) continue;
        lengths.push_back({std::string(prefix) + p.id, values.at(p.id).number(), p.unit,
                           overrides.contains(p.id) ? LengthRecord::kSet : origin});
    }
}

}  // namespace

std::string cell_name(const CellPlan& plan) {
    std::string name = plan.method + "/" + plan.preset;
    if (plan.filter) name += "/" + *plan.filter;
    std::vector<std::string> changes = changes_of(plan, "=");
    // Signals cost time: one method may be a cell with them and one without.
    for (const std::string& id : plan.signals) changes.push_back("signal=" + id);
    for (const auto& [id, value] : plan.converged)
        changes.push_back(fmt::format("converged.{}={}", id, value.text()));
    if (!changes.empty()) name += fmt::format("/{}", fmt::join(changes, ","));
    return name;
}

PresetFilter filter_of(const CellPlan& plan, const MethodDescriptor& method) {
    return plan.filter ? PresetFilter{*plan.filter} : method.filter_of(plan.preset);
}

std::string setting_text(const CellPlan& plan) {
    return fmt::format("{}", fmt::join(changes_of(plan, " "), ", "));
}

ParameterValues drawn_values(const MethodDescriptor& method, const std::string& preset,
                             const ParameterValues& overrides, std::optional<double> drawn_for_m) {
    return drawn_for_m ? values_for_radius(method, *drawn_for_m, preset, overrides)
                       : method.values(preset, overrides);
}

void light(MethodRequest& request, const MethodDescriptor& lighting, std::optional<double> drawn_for_m) {
    request.lighting = &lighting;
    request.lighting_parameters = drawn_values(lighting, "default", {}, drawn_for_m);
}

namespace {

const OutsideMethod* find_outside(const Registry& registry, const std::string& id) {
    return find_row(registry.outside, id,
                    [](const OutsideMethod& outside) { return std::string_view(outside.method.id); });
}

const MethodDescriptor& described(const std::string& id, const Registry& registry) {
    if (id == kFewRays) return registry.few_rays;
    const OutsideMethod* outside = find_outside(registry, id);
    return outside != nullptr ? outside->method : find_method(registry.methods, id);
}

}  // namespace

std::shared_ptr<const Contestant> contestant_on(const std::string& view, double radius_m,
                                                const ResolvedCell& cell, const Registry& registry) {
    const OutsideMethod* outside = find_outside(registry, cell.plan.method);
    if (outside == nullptr) return contestant_of(cell.request);
    if (outside->command) return command_image(*outside, {cell.plan.preset, radius_m, cell.request.seed});
    return folder_image(*outside, view);
}

ResolvedCell resolve(const CellPlan& plan, const Registry& registry, std::uint64_t seed,
                     std::optional<double> drawn_for_m) {
    ResolvedCell cell;
    cell.plan = plan;
    const MethodDescriptor& method = described(plan.method, registry);
    // An absolute preset keeps its filter's lengths as well.
    const bool absolute = method.absolute_presets.contains(plan.preset);
    if (absolute) drawn_for_m.reset();
    const char* origin = absolute      ? LengthRecord::kPreset
                         : drawn_for_m ? LengthRecord::kRun
                                       : LengthRecord::kOwn;
    cell.request.method = &method;
    const std::optional<double> method_for_m =
        drawn_for_m ? std::optional(*drawn_for_m * plan.radius_factor) : std::nullopt;
    cell.request.parameters = drawn_values(method, plan.preset, plan.overrides, method_for_m);
    if (const OutsideMethod* outside = find_outside(registry, plan.method))
        cell.request.parameters = outside->shown_values(plan.preset);
    cell.request.seed = seed + static_cast<std::uint64_t>(plan.draw);
    if (!plan.signals.empty() && !gives_signals(plan.modes.resolution))
        throw usage_error("bent normals and cones are given at full resolution alone", "--signals",
                          "--resolution full or half-gbuffer, or no --signals");
    cell.request.signals = plan.signals;
    plan.modes.apply_to(cell.request);
    add_lengths(method, cell.request.parameters, plan.overrides, origin, "", cell.lengths);
    const PresetFilter chosen = filter_of(plan, method);
    cell.filter = chosen.filter;
    if (cell.filter != "none") {
        const MethodDescriptor& filter = find_method(registry.filters, cell.filter);
        cell.request.filter = &filter;
        cell.request.filter_parameters =
            drawn_values(filter, chosen.preset, plan.filter_overrides, drawn_for_m);
        add_lengths(filter, cell.request.filter_parameters, plan.filter_overrides, origin, kFilterPrefix,
                    cell.lengths);
    }
    cell.own = own_truth(method, cell.request.parameters);
    if (plan.converged.empty()) return cell;
    ParameterValues changes = plan.overrides;
    for (const auto& [id, value] : plan.converged) changes[id] = value;
    cell.converged = cell.request;
    cell.converged->signals.clear();
    cell.converged->parameters = drawn_values(method, plan.preset, changes, drawn_for_m);
    return cell;
}

}  // namespace aoscore
