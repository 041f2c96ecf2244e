#include "cli/command.h"
#include "cli/program.h"
#include "cli/shared_options.h"
#include "core/shell.h"
#include "jobs/job_listing.h"

#include <memory>

namespace aoscore {
namespace {

struct Options {
    std::string key;
    std::filesystem::path cache;
};

ExitCode run(const Options& options) {
    std::vector<std::string> words = arguments_of_job(options.key, options.cache);
    std::erase(words, "--jobs");
    // Artifacts name the command that asked for all of them.
    std::string command_line = "aoscore";
    for (const std::string& word : words) command_line += " " + shell_quoted(word);
    words.insert(words.end(), {"--job", options.key});
    return run_words(words, command_line);
}

}  // namespace

CommandEntry add_job_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand(
        "job", "Make one artifact that --jobs has listed, by its key, and keep it in the store");
    const auto options = std::make_shared<Options>();
    options->cache = default_cache_dir();
    app->add_option("key", options->key, "As --jobs prints it")->required();
    return {app, [options] { return run(*options); }};
}

}  // namespace aoscore
