#pragma once

#include "plan/plan.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Lists the plan's jobs as JobListing does.
nlohmann::json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments);

/// Makes one artifact of the plan alone, as make_alone() does. Throws usage_error for a key that the plan
/// does not have, or whose artifact is not stored.
void make_job(const ExperimentPlan& plan, const std::string& key);

}  // namespace aoscore
