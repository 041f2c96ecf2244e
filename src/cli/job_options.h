#pragma once

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace aoscore {

/// Options by which a command lists its jobs or makes one, instead of making all of them.
struct JobOptions {
    bool list = false;  ///< print the jobs
    std::string only;   ///< key of the one job to make; empty: all
};
/// Adds --jobs and --job.
void add_job_options(CLI::App& app, JobOptions& options);

/// Prints the JSON of `list`, or calls `make` with the key, where the options ask for it; returns whether
/// they do.
bool only_lists_or_makes_one(const JobOptions& options, const std::function<nlohmann::json()>& list,
                             const std::function<void(const std::string& key)>& make);

}  // namespace aoscore
