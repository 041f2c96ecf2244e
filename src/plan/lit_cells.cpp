#include "plan/lit_cells.h"

#include "core/known_names.h"
#include "core/signal.h"
#include "image/environment_file.h"
#include "jobs/truth_signals.h"

#include <algorithm>

namespace aoscore {
bool gives_signals(Resolution resolution) {
    return resolution == Resolution::full || resolution == Resolution::half_gbuffer;
}

std::shared_ptr<const Environment> named_environment(const std::string& name, double turn_deg) {
    if (name == kSkyId) return nullptr;
    return std::make_shared<const Environment>(read_environment(name, turn_deg));
}

void light_cells(const std::vector<MethodDescriptor>& methods, ViewPlan& view,
                 std::vector<std::string>& warnings) {
    const std::vector<std::string> signals = further_signals();
    view.extras |= extras_for(signals);
    bool lacks_signals = false;
    for (CellPlan& cell : view.cells) {
        cell.lit_by_environment = true;
        const MethodDescriptor* method = find_row(methods, cell.method);
        if (method == nullptr) continue;
        for (const std::string& id : signals) {
            if (!method->gives(id) || std::ranges::find(cell.signals, id) != cell.signals.end()) continue;
            if (gives_signals(cell.modes.resolution)) {
                cell.signals.push_back(id);
            } else {
                lacks_signals = true;
            }
        }
    }
    if (lacks_signals)
        warnings.emplace_back(
            "bent normals and cones are given at full resolution alone (--resolution full or half-gbuffer): "
            "methods at another are lit by the surface's normal alone");
}

}  // namespace aoscore
