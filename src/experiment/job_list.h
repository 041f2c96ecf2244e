#pragma once

#include "plan/plan.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Lists the plan's jobs as JobListing does.
nlohmann::json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments);

/// Makes these artifacts of the plan alone, as ChosenJobs does; returns how many failed. Throws usage_error
/// for a key that the plan does not have, or whose artifact is not stored.
std::size_t make_jobs(const ExperimentPlan& plan, const std::vector<std::string>& keys);

}  // namespace aoscore
