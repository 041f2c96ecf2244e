#pragma once

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace aoscore {

/// What a command does with its jobs instead of making all of them.
struct JobOptions {
    bool list = false;  ///< print them
    std::string only;   ///< key of the one to be made; empty: all
};
/// --jobs and --job.
void add_job_options(CLI::App& app, JobOptions& options);

/// Prints what `list` gives, or calls `make` with the key, where that was asked for; returns whether it was.
bool only_lists_or_makes_one(const JobOptions& options, const std::function<nlohmann::json()>& list,
                             const std::function<void(const std::string& key)>& make);

}  // namespace aoscore
