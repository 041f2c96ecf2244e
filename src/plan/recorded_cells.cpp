#include "plan/recorded_cells.h"

#include "screen/screen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace aoscore {
namespace {

/// The first thing that a cell needs and the frame lacks; empty where it lacks none.
std::string lacking(const CellPlan& cell, const MethodDescriptor& method, const std::set<std::string>& held) {
    if (cell.modes.guard_band.width > 0) return "guard band, which is drawn from a scene";
    if (method.side_layers) return "side layers, which are drawn from a scene";
    if (method.depth_layers) return "depth layers, which are drawn from a scene";
    for (const Pass& pass : method.passes) {
        for (const std::string& input : pass.inputs) {
            if (gbuffer_inputs().contains(input) && !held.contains(input)) return input;
        }
    }
    return {};
}

}  // namespace

void leave_out_cells(const RecordedView& view, const std::vector<MethodDescriptor>& methods,
                     std::vector<CellPlan>& cells, std::vector<std::string>& warnings) {
    const std::set<std::string> held = view.channels();
    std::map<std::string, std::set<std::string>> left_out;  // methods by reason
    std::erase_if(cells, [&](const CellPlan& cell) {
        const std::string reason = lacking(cell, find_method(methods, cell.method), held);
        if (!reason.empty()) left_out[reason].insert(cell.method);
        return !reason.empty();
    });
    for (CellPlan& cell : cells) cell.own_truth = false;
    for (const auto& [reason, ids] : left_out)
        warnings.push_back(
            fmt::format("left out, since the frame has no {}: {}", reason, fmt::join(ids, ", ")));
}

}  // namespace aoscore
