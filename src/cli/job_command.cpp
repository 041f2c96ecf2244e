#include "cli/command.h"
#include "cli/job_options.h"
#include "cli/shared_options.h"
#include "core/folders.h"
#include "jobs/job_listing.h"

#include <memory>

namespace aoscore {
namespace {

struct Options {
    std::string key;
    std::filesystem::path cache;
};

ExitCode run(const Options& options, const GlobalOptions& global) {
    return run_jobs(command_of_job(options.key, options.cache), {options.key}, global);
}

}  // namespace

CommandEntry add_job_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "job", "Make one artifact that --jobs has listed, by its key, and keep it in the store");
    const auto options = std::make_shared<Options>();
    options->cache = cache_dir();
    app->add_option("key", options->key, "As --jobs prints it")->required();
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
