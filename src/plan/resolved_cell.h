#pragma once

#include "jobs/contest/contestant.h"
#include "plan/plan.h"
#include "reference/truth.h"
#include "screen/screen.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The methods and filters that a run may name.
struct Registry {
    std::vector<MethodDescriptor> methods;
    std::vector<MethodDescriptor> filters;
    MethodDescriptor fixed_pass;
    MethodDescriptor lighting;
    MethodDescriptor few_rays;
    std::vector<OutsideMethod> outside = {};
};
/// Loads the methods as load_asked_methods() does, and all filters.
Registry load_registry(const std::filesystem::path& methods_dir, const std::vector<std::string>& asked,
                       std::vector<std::string>& warnings);
/// Loads the program's own methods and filters.
Registry load_registry();

/// A cell whose names are looked up and whose parameters are complete.
struct ResolvedCell {
    CellPlan plan;
    MethodRequest request;
    std::optional<MethodRequest> converged = {};  ///< its own converged picture, where it is asked for
    TruthQuery own;
    std::string filter = "none";
    std::vector<LengthRecord> lengths;
};

/// The preset's values, whose lengths follow the AO radius `drawn_for_m`; empty: they are the descriptor's.
ParameterValues drawn_values(const MethodDescriptor& method, const std::string& preset,
                             const ParameterValues& overrides, std::optional<double> drawn_for_m);

/// Adds the lighting pass to the request. Its lengths follow the AO radius `drawn_for_m`; empty: they are the
/// descriptor's. `lighting` must outlive it.
void light(MethodRequest& request, const MethodDescriptor& lighting, std::optional<double> drawn_for_m);

/// The cell's name within its view: "hbao/quality", with its filter and whatever else its plan changes:
/// "hbao/quality/none/directions=8,resolution=half".
std::string cell_name(const CellPlan& plan);
/// The plan's changes of the preset in words: "directions 8, resolution half"; empty without any. The filter
/// is not among them, since it has a column of its own.
std::string setting_text(const CellPlan& plan);

/// The cell's filter: with its default preset where the plan names it, else as the method's preset has it.
PresetFilter filter_of(const CellPlan& plan, const MethodDescriptor& method);

/// Resolves the cell. Its lengths follow the AO radius `drawn_for_m`; empty: they are the descriptors'.
/// Throws usage_error for an unknown method, preset, filter or parameter, and for a length that leaves its
/// range. `registry` must outlive the result.
ResolvedCell resolve(const CellPlan& plan, const Registry& registry, std::uint64_t seed,
                     std::optional<double> drawn_for_m);

/// The contestant that the cell scores on the view of this id, which is ranked at this radius.
std::shared_ptr<const Contestant> contestant_on(const std::string& view, double radius_m,
                                                const ResolvedCell& cell, const Registry& registry);

}  // namespace aoscore
