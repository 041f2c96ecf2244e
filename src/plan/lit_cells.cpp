#include "plan/lit_cells.h"

#include "core/known_names.h"
#include "core/signal.h"
#include "image/environment_file.h"
#include "jobs/truth_signals.h"

#include <algorithm>

namespace aoscore {

std::shared_ptr<const Environment> named_environment(const std::string& name, double turn_deg) {
    if (name == kSkyId) return nullptr;
    return std::make_shared<const Environment>(read_environment(name, turn_deg));
}

void light_cells(const std::vector<MethodDescriptor>& methods, ViewPlan& view) {
    const std::vector<std::string> signals = further_signals();
    view.extras |= extras_for(signals);
    for (CellPlan& cell : view.cells) {
        cell.lit_by_environment = true;
        const MethodDescriptor* method = find_row(methods, cell.method);
        if (method == nullptr) continue;
        for (const std::string& id : signals) {
            if (method->gives(id) && std::ranges::find(cell.signals, id) == cell.signals.end())
                cell.signals.push_back(id);
        }
    }
}

}  // namespace aoscore
