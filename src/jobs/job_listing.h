#pragma once

#include "jobs/executor.h"
#include "jobs/planned_command.h"
#include "store/artifact_store.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The jobs of one command, none of them made: {"jobs": [{"key", "kind", "about", "inputs", "after", "asked",
/// "known", "unit", "cost_s"}]}, each once. A job is "asked" for where the results hold its artifact, and
/// "known" where the store has that. Jobs of one "unit" are best made by one process: they share what they
/// need, or meet the same disturbances. "cost_s" is the estimate. `arguments` are the command line's; the
/// command is kept in the store under every job, with the job's name, so that any process that shares it can
/// make the job from its key alone.
class JobListing {
  public:
    /// `store` must outlive it.
    JobListing(const ArtifactStore& store, std::vector<std::string> arguments)
        : store_(store), command_(PlannedCommand::of(std::move(arguments)).json()) {}

    void add(const JobGraph& graph, const std::function<double(const Job&)>& cost_s);
    nlohmann::json json() const { return {{"jobs", jobs_}}; }

  private:
    const ArtifactStore& store_;
    nlohmann::json command_;
    nlohmann::json jobs_ = nlohmann::json::array();
    std::set<Key> listed_;
    std::size_t graphs_ = 0;
};

/// The command that listed this job. Throws usage_error where none did.
PlannedCommand command_of_job(const std::string& key, const std::filesystem::path& cache);

/// Some of a command's jobs, to be made without the others.
class ChosenJobs {
  public:
    /// `store` must outlive it. Throws usage_error where it keeps nothing.
    ChosenJobs(const std::vector<std::string>& keys, const ArtifactStore& store);

    /// Whether the graph has some of those that no earlier graph had. Throws usage_error for one whose
    /// artifact is not kept.
    bool any_in(const JobGraph& graph) const;
    /// Makes these artifacts, with the inputs that are missing, and nothing where they are there; says which.
    /// Where one fails, it is named in a warning, and the others are made. Throws file_error where the store
    /// cannot be written, since the artifacts are all that is asked for.
    void make(const JobGraph& graph, Maker& maker);

    /// How many failed. Throws file_error for a key that the command had when it was listed and has no more,
    /// usage_error for one that nobody listed, file_error where the store has lost what was made.
    std::size_t failed() const;

  private:
    const ArtifactStore& store_;
    std::set<std::string> left_;
    std::size_t failed_ = 0;
};

}  // namespace aoscore
