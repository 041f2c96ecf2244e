#pragma once

#include "stress/stress.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Lists the jobs of a stress test as JobListing does.
nlohmann::json list_stress_jobs(const StressPlan& plan, const std::vector<std::string>& arguments);

/// Makes one of its artifacts alone, as make_alone() does. Throws usage_error for a key that the plan does
/// not have, or whose artifact is not stored.
void make_stress_job(const StressPlan& plan, const std::string& key);

}  // namespace aoscore
