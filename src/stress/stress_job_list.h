#pragma once

#include "stress/stress.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// Lists the jobs of a stress test as JobListing does.
nlohmann::json list_stress_jobs(const StressPlan& plan, const std::vector<std::string>& arguments);

/// Makes some of its artifacts alone, as ChosenJobs does; returns how many failed. Throws usage_error for a
/// key that the plan does not have, or whose artifact is not stored.
std::size_t make_stress_jobs(const StressPlan& plan, const std::vector<std::string>& keys);

}  // namespace aoscore
