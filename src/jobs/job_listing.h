#pragma once

#include "jobs/executor.h"
#include "store/artifact_store.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The jobs of one command, none of them made: {"jobs": [{"key", "kind", "about", "inputs", "after", "asked",
/// "known"}]}, each once. A job is "asked" for where the results hold its artifact, and "known" where the
/// store has that. `arguments` are the command line's; they are kept in the store under every job, so that
/// any process that shares it can make the job from its key alone.
class JobListing {
  public:
    /// `store` must outlive it.
    JobListing(const ArtifactStore& store, std::vector<std::string> arguments)
        : store_(store), arguments_(std::move(arguments)) {}

    void add(const JobGraph& graph);
    nlohmann::json json() const { return {{"jobs", jobs_}}; }

  private:
    const ArtifactStore& store_;
    std::vector<std::string> arguments_;
    nlohmann::json jobs_ = nlohmann::json::array();
    std::set<Key> listed_;
};

/// The arguments of the command that listed this job. Throws usage_error where none did.
std::vector<std::string> arguments_of_job(const std::string& key, const std::filesystem::path& cache);

/// Whether the graph has the job. Throws usage_error for one whose artifact is not kept, and where there is
/// no store to keep it in.
bool has_job_to_make(const JobGraph& graph, const std::string& key, const ArtifactStore& store);

/// Makes the job's artifact, with the inputs that are missing, and nothing where it is there; says which.
/// Throws internal_error where it fails.
void make_alone(const JobGraph& graph, const std::string& key, Maker& maker);

/// Throws usage_error for a key that none of a command's graphs has.
[[noreturn]] void throw_no_such_job(const std::string& key);

}  // namespace aoscore
