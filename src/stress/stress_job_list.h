#pragma once

#include "stress/stress.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The jobs of a stress test, as JobListing has them.
nlohmann::json list_stress_jobs(const StressPlan& plan, const std::vector<std::string>& arguments);

/// Makes one of its artifacts alone, as make_alone() does. Throws usage_error for a key that is none of the
/// plan's or whose artifact is not kept.
void make_stress_job(const StressPlan& plan, const std::string& key);

}  // namespace aoscore
