#include "plan/advice_steps.h"

#include "core/known_names.h"
#include "screen/method/lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace aoscore {
namespace {

constexpr double kLargerRadius = 1.5;
constexpr const char* kGuardBandWidth = "10%";

/// The cell that steps lead away from.
struct StepSource {
    const ViewPlan& view;
    const CellPlan& cell;
    const MethodDescriptor& method;
    const Registry& registry;
};

/// A changed cell; empty where the cell's own analysis tells what the change would bring.
struct OfferedStep {
    std::string what;
    std::optional<CellPlan> cell;
};

/// The steps of one kind, or why there are none.
struct OfferedSteps {
    std::vector<OfferedStep> steps;
    std::string reason;
};

OfferedSteps none(std::string reason) {
    return {{}, std::move(reason)};
}

OfferedSteps one(std::string what, CellPlan changed) {
    return {{{std::move(what), std::move(changed)}}, ""};
}

OfferedSteps more_taps(const StepSource& from) {
    const ParameterValues values = from.method.values(from.cell.preset, from.cell.overrides);
    OfferedSteps offered;
    for (const Parameter& p : from.method.parameters) {
        if (!p.taps) continue;
        const auto count = static_cast<std::int64_t>(values.at(p.id).number());
        if (2.0 * static_cast<double>(count) > p.highest) continue;
        CellPlan changed = from.cell;
        changed.overrides[p.id] = 2 * count;
        offered.steps.push_back({fmt::format("{} {} to {}", p.id, count, 2 * count), std::move(changed)});
    }
    if (offered.steps.empty()) offered.reason = "its descriptor names no count of taps that can be doubled";
    return offered;
}

OfferedSteps full_resolution(const StepSource& from) {
    if (from.cell.modes.resolution == Resolution::full) return none("every pixel is shaded already");
    CellPlan changed = from.cell;
    changed.modes.resolution = Resolution::full;
    return one("all pixels", std::move(changed));
}

OfferedSteps exact_normals(const StepSource& from) {
    bool reads_some = false, reads_others = false;
    for (const Pass& pass : from.method.passes) {
        for (const std::string& input : pass.inputs) {
            if (!input.starts_with("normal_")) continue;
            reads_some = true;
            reads_others |= input != "normal_geometric";
        }
    }
    if (!reads_some) return none("it reads no normals");
    const Normals normals = from.cell.modes.normals;
    if (normals == Normals::geometric || (normals == Normals::as_described && !reads_others))
        return none("its normals are those of the triangles already");
    CellPlan changed = from.cell;
    changed.modes.normals = Normals::geometric;
    return one("normals of the triangles", std::move(changed));
}

OfferedSteps guard_band(const StepSource& from) {
    if (from.cell.modes.guard_band != GuardBand()) return none("it has one already");
    CellPlan changed = from.cell;
    changed.modes.guard_band = parse_guard_band(kGuardBandWidth);
    return one(fmt::format("{} on every side", kGuardBandWidth), std::move(changed));
}

/// Whether the preset's lengths, as parts of the radius that they are meant for, are those of another method.
bool same_lengths(const MethodDescriptor& a, const std::string& preset_a, const MethodDescriptor& b,
                  const std::string& preset_b) {
    if (a.absolute_presets.contains(preset_a) || b.absolute_presets.contains(preset_b)) return false;
    const ParameterValues of_a = values_for_radius(a, 1, preset_a);
    const ParameterValues of_b = values_for_radius(b, 1, preset_b);
    return std::ranges::all_of(a.parameters, [&](const Parameter& p) {
        if (p.length_power == 0 || b.find_parameter(p.id) == nullptr) return true;
        const double wanted = of_a.at(p.id).number();
        return std::abs(of_b.at(p.id).number() - wanted) <= 1e-6 * std::abs(wanted);
    });
}

OfferedSteps second_layer(const StepSource& from) {
    if (from.method.depth_layers) return none("it reads several layers already");
    if (!from.method.second_layer) return none("no method is this one over two depth layers");
    const auto& [id, preset] = *from.method.second_layer;
    const MethodDescriptor& other = find_method(from.registry.methods, id);
    if (!same_lengths(from.method, from.cell.preset, other, preset))
        return none(fmt::format("the lengths of {} are not those of {}/{}", from.cell.preset, id, preset));
    CellPlan changed = from.cell;
    changed.method = id;
    changed.preset = preset;
    changed.filter = filter_of(from.cell, from.method).filter;
    for (const auto& [parameter, value] : from.method.values(from.cell.preset, from.cell.overrides)) {
        const Parameter* p = other.find_parameter(parameter);
        if (p != nullptr && p->length_power == 0 && p->accepts(value)) changed.overrides[parameter] = value;
    }
    std::erase_if(changed.signals, [&](const std::string& signal) { return !other.gives(signal); });
    return one(fmt::format("{}/{}", id, preset), std::move(changed));
}

OfferedSteps larger_radius(const StepSource& from) {
    const std::string& radius = from.method.reference_radius.parameter;
    if (radius.empty()) return none("it has no radius");
    if (from.view.own_parameters || from.cell.overrides.contains(radius) ||
        from.method.absolute_presets.contains(from.cell.preset))
        return none("its radius does not follow the view's");
    CellPlan changed = from.cell;
    changed.radius_factor = kLargerRadius * from.cell.radius_factor;
    return one(fmt::format("{:g} times the radius", changed.radius_factor), std::move(changed));
}

OfferedSteps tuned_preset(const StepSource& from) {
    OfferedSteps offered;
    for (const auto& [preset, tuning] : from.method.tunings) {
        if (tuning.from != from.cell.preset) continue;
        CellPlan changed = from.cell;
        changed.preset = preset;
        offered.steps.push_back({preset, std::move(changed)});
    }
    if (offered.steps.empty()) offered.reason = "no preset was tuned from " + from.cell.preset;
    return offered;
}

OfferedSteps from_own_analysis(const StepSource&) {
    return {{{"", std::nullopt}}, ""};
}

OfferedSteps no_filter(const StepSource& from) {
    const std::string filter = filter_of(from.cell, from.method).filter;
    if (filter == "none") return none("no filter follows it");
    CellPlan changed = from.cell;
    changed.filter = "none";
    changed.filter_overrides.clear();
    return one("without " + filter, std::move(changed));
}

/// How the steps of each of step_kinds() are made, in their order.
struct StepMaker {
    std::string_view id;
    OfferedSteps (*offer)(const StepSource&);
};
constexpr std::array<StepMaker, 10> kMakers{{{"more-taps", more_taps},
                                             {"full-resolution", full_resolution},
                                             {"exact-normals", exact_normals},
                                             {"guard-band", guard_band},
                                             {"second-layer", second_layer},
                                             {"larger-radius", larger_radius},
                                             {"tuned-preset", tuned_preset},
                                             {"best-strength", from_own_analysis},
                                             {"no-noise", from_own_analysis},
                                             {"no-filter", no_filter}}};

/// Adds a step's cell to the view; returns its index.
std::size_t add_step_cell(ViewPlan& view, CellPlan cell) {
    cell.step = true;
    cell.keep_image = false;
    cell.own_truth = false;
    cell.repeats = false;
    return shared_cell(view, std::move(cell));
}

AdvicePlan advice_for(ViewPlan& view, std::size_t cell_index, const MethodDescriptor& method,
                      const Registry& registry) {
    view.cells[cell_index].repeats = true;
    const CellPlan cell = view.cells[cell_index];  // a copy, since steps are added to the cells
    AdvicePlan advice;
    advice.cell_index = cell_index;
    for (const StepMaker& maker : kMakers) {
        OfferedSteps offered = maker.offer({view, cell, method, registry});
        if (!offered.reason.empty()) advice.skipped.push_back({std::string(maker.id), offered.reason});
        for (OfferedStep& step : offered.steps) {
            StepPlan planned{std::string(maker.id), step.what, {}};
            if (step.cell) planned.cell_index = add_step_cell(view, std::move(*step.cell));
            advice.steps.push_back(std::move(planned));
        }
    }
    return advice;
}

}  // namespace

void add_advice(ExperimentPlan& plan, const Registry& registry) {
    for (std::size_t v = 0; v < plan.views.size(); ++v) {
        const std::size_t asked = plan.views[v].cells.size();
        for (std::size_t c = 0; c < asked; ++c) {
            const MethodDescriptor* method = find_row(registry.methods, plan.views[v].cells[c].method);
            if (method == nullptr || method->role == MethodRole::bound) continue;
            plan.advice.push_back(advice_for(plan.views[v], c, *method, registry));
            plan.advice.back().view_index = v;
        }
    }
}

}  // namespace aoscore
