#pragma once

#include "plan/plan.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The plan's jobs, as JobListing has them.
nlohmann::json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments);

/// Makes one artifact of the plan alone, as make_alone() does. Throws usage_error for a key that is none of
/// the plan's or whose artifact is not kept.
void make_job(const ExperimentPlan& plan, const std::string& key);

}  // namespace aoscore
