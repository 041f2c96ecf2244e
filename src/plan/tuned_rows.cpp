#include "plan/tuned_rows.h"

#include "plan/resolved_cell.h"
#include "screen/method/preset_tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace aoscore {
namespace {

constexpr const char* kFrom = "default";  // bundled presets are tuned from it
constexpr const char* kStep = "tuned-preset";

/// The row's cell with the tuned preset at as many taps.
CellPlan tuned_cell(const CellPlan& row, const MethodDescriptor& method, const std::string& preset) {
    CellPlan cell;
    cell.method = row.method;
    cell.preset = preset;
    cell.modes = row.modes;
    cell.filter = row.filter;
    const ParameterValues published = method.values(row.preset, row.overrides);
    const ParameterValues tuned = method.values(preset);
    for (const Parameter& p : method.parameters) {
        if (p.taps && published.at(p.id) != tuned.at(p.id)) cell.overrides[p.id] = published.at(p.id);
    }
    cell.step = true;
    cell.keep_image = false;
    return cell;
}

/// "tuned, samples 16".
std::string step_text(const CellPlan& tuned) {
    std::string text = tuned.preset;
    for (const auto& [id, value] : tuned.overrides) text += fmt::format(", {} {}", id, value.text());
    return text;
}

TunedRowPlan tuned_row(ViewPlan& view, std::size_t row, const MethodDescriptor& method) {
    const CellPlan cell = view.cells[row];  // a copy, since the step's is added to the cells
    TunedRowPlan planned;
    planned.step.cell_index = row;
    const auto found =
        std::ranges::find_if(method.tunings, [](const auto& tuning) { return tuning.second.from == kFrom; });
    if (found == method.tunings.end()) {
        planned.step.skipped.push_back({kStep, fmt::format("no preset was tuned from {}", kFrom)});
        return planned;
    }
    planned.tuning = tuning_json(found->second);
    const CellPlan changed = tuned_cell(cell, method, found->first);
    planned.step.steps.push_back({kStep, step_text(changed), shared_cell(view, changed)});
    return planned;
}

}  // namespace

void add_tuned_rows(ExperimentPlan& plan) {
    if (plan.tables.empty()) return;
    const std::vector<MethodDescriptor> methods = load_methods();
    for (TablePlan& table : plan.tables) {
        ViewPlan& view = plan.views[table.view_index];
        for (const std::size_t row : table.cell_indices) {
            TunedRowPlan& planned =
                table.tuned.emplace_back(tuned_row(view, row, find_method(methods, view.cells[row].method)));
            planned.step.view_index = table.view_index;
        }
    }
}

}  // namespace aoscore
