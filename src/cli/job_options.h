#pragma once

#include "cli/command.h"
#include "core/error.h"
#include "jobs/planned_command.h"

#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Options by which a command lists its jobs, divides them or makes some, instead of making all of them.
struct JobOptions {
    bool list = false;                 ///< print the jobs
    std::vector<std::string> only;     ///< keys of the jobs to make; empty: all
    std::filesystem::path parts_file;  ///< write the jobs in parts into this file; empty: do not
    std::size_t parts = 1;             ///< their number
};
/// Adds --jobs and --job, and what `plan` hands on.
void add_job_options(CLI::App& app, JobOptions& options);

/// Does what the options ask for instead of the command's work, with the JSON of `list`, which is given the
/// command's words without these options, or with `make`, which returns how many jobs failed. `words` are all
/// of the command's. Empty where the options ask for nothing.
std::optional<ExitCode> list_or_make_some(
    const JobOptions& options, std::vector<std::string> words,
    const std::function<nlohmann::json(const std::vector<std::string>& words)>& list,
    const std::function<std::size_t(const std::vector<std::string>& keys)>& make);

/// Has the command of these words write its jobs in parts.
ExitCode run_division(std::vector<std::string> words, const std::filesystem::path& file, std::size_t parts);

/// Has the command make these jobs alone, in the folder where it was planned, and warns of each file of it
/// that has changed since. The artifacts name the command, which asked for all
/// of them, and the kind of node whose times count. Of the options that the user gave with the jobs, --quiet
/// is heeded; throws usage_error for --seed, --threads and --gl, and for another --node-kind, which the
/// command decides.
ExitCode run_jobs(const PlannedCommand& command, const std::vector<std::string>& keys,
                  const GlobalOptions& given);

}  // namespace aoscore
