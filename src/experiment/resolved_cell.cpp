#include "experiment/resolved_cell.h"

#include "experiment/own_truth.h"

namespace aoscore {

Registry load_registry(const std::filesystem::path& methods_dir) {
    return {load_methods(methods_dir), load_filters()};
}

ResolvedCell resolve(const CellPlan& plan, const Registry& registry, std::uint64_t seed) {
    ResolvedCell cell;
    cell.plan = plan;
    const MethodDescriptor& method = find_method(registry.methods, plan.method);
    cell.request.method = &method;
    cell.request.parameters = method.values(plan.preset, plan.overrides);
    cell.request.seed = seed;
    plan.modes.apply_to(cell.request);
    if (plan.filter) {
        cell.filter = *plan.filter;
    } else if (const auto own = method.preset_filters.find(plan.preset); own != method.preset_filters.end()) {
        cell.filter = own->second;
    }
    if (cell.filter != "none") {
        cell.request.filter = &find_method(registry.filters, cell.filter);
        cell.request.filter_parameters = cell.request.filter->values("default");
    }
    cell.own = own_truth(method, cell.request.parameters);
    return cell;
}

}  // namespace aoscore
