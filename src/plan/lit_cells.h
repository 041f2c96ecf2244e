#pragma once

#include "core/environment.h"
#include "plan/plan.h"
#include "screen/method/method.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Whether methods give signals beside visibility where they shade these pixels, as MethodRunner has it.
bool gives_signals(Resolution resolution);

/// The name of the generated sky among environments.
inline constexpr std::string_view kSkyId = "sky";

/// The environment of that name, for ViewPlan::environment: null for kSkyId, else a file's. Throws as
/// read_environment() does.
std::shared_ptr<const Environment> named_environment(const std::string& name, double turn_deg);

/// Has every cell of the view lit, with the signals that light takes of the methods that give them; the truth
/// is asked for these signals. Contestants that are not among `methods` are lit by visibility alone, and so
/// are methods at a resolution at which they give no signals: `warnings` then says so.
void light_cells(const std::vector<MethodDescriptor>& methods, ViewPlan& view,
                 std::vector<std::string>& warnings);

}  // namespace aoscore
