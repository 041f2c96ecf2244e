#pragma once

#include "plan/plan.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace aoscore {

/// The jobs of a plan, none of them made: {"jobs": [{"key", "kind", "about", "inputs", "after", "asked",
/// "known"}]}. A job is "asked" for where the results hold its artifact, and "known" where the store has
/// that. `arguments` are the command line's; they are kept in the store under every job, so that any process
/// that shares it can make the job from its key alone.
nlohmann::json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments);

/// The arguments of the command that listed this job. Throws usage_error where none did.
std::vector<std::string> arguments_of_job(const std::string& key, const std::filesystem::path& cache);

/// Makes one artifact of the plan, with the inputs that are missing, and keeps it in the store; nothing where
/// it is there. Throws usage_error for a key that is none of the plan's or whose artifact is not kept.
void make_job(const ExperimentPlan& plan, const std::string& key);

}  // namespace aoscore
