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
    std::vector<ImageFolder> folders = {};
};
/// Methods as load_asked_methods() has them.
Registry load_registry(const std::filesystem::path& methods_dir, const std::vector<std::string>& asked,
                       std::vector<std::string>& warnings);
/// The program's own.
Registry load_registry();

/// A cell with its names looked up and its parameters complete.
struct ResolvedCell {
    CellPlan plan;
    MethodRequest request;
    TruthQuery own;
    std::string filter = "none";
    std::vector<LengthRecord> lengths;
};

/// The preset's values drawn for the AO radius `drawn_for_m`; empty: with its descriptor's lengths.
ParameterValues drawn_values(const MethodDescriptor& method, const std::string& preset,
                             const ParameterValues& overrides, std::optional<double> drawn_for_m);

/// Gives the request the lighting pass, drawn for the AO radius `drawn_for_m`; empty: with its descriptor's
/// lengths. `lighting` must outlive it.
void light(MethodRequest& request, const MethodDescriptor& lighting, std::optional<double> drawn_for_m);

/// The cell's name within its view: "hbao/quality", with its filter and whatever else its plan changes:
/// "hbao/quality/none/directions=8,resolution=half".
std::string cell_name(const CellPlan& plan);
/// What the plan changes of the preset, in words: "directions 8, resolution half"; empty when nothing. The
/// filter is not among it: it stands in a column of its own.
std::string setting_text(const CellPlan& plan);

/// The filter that the cell is run with: with its default preset where the plan names it, else the method's
/// preset's own.
PresetFilter filter_of(const CellPlan& plan, const MethodDescriptor& method);

/// The cell with its lengths drawn for the AO radius `drawn_for_m`; empty: as descriptors have them. Throws
/// usage_error for an unknown method, preset, filter or parameter, and for a length that leaves its range.
/// `registry` must outlive the result.
ResolvedCell resolve(const CellPlan& plan, const Registry& registry, std::uint64_t seed,
                     std::optional<double> drawn_for_m);

/// What is scored of the cell on the view of this id.
std::shared_ptr<const Contestant> contestant_on(const std::string& view, const ResolvedCell& cell,
                                                const Registry& registry);

}  // namespace aoscore
