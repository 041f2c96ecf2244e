#include "cli/command.h"
#include "cli/outcome_options.h"
#include "core/output.h"
#include "page/document/page_key.h"
#include "page/page.h"
#include "page/stress_page.h"
#include "page/tuning_page.h"
#include "results/stress_results.h"
#include "results/tuning_record.h"
#include "store/code_digest.h"
#include "verdict/baseline.h"
#include "verdict/rankings.h"

#include <memory>

namespace aoscore {
namespace {

struct PageOptions {
    std::filesystem::path results;
    OutcomeOptions outcome;
    bool everything = false;
};

/// Refuses options that only the results of scores heed, for `results` of another kind.
void require_no_options(const PageOptions& options, const std::string& results) {
    const OutcomeOptions& outcome = options.outcome;
    std::string given;
    const auto add = [&](bool is_given, const char* option) {
        if (is_given) given += (given.empty() ? "" : ", ") + std::string(option);
    };
    add(!outcome.fail.empty(), "--fail");
    add(!outcome.warn.empty(), "--warn");
    add(!outcome.exports.empty(), "--export");
    add(!outcome.baseline.empty(), "--baseline");
    add(options.everything, "--everything");
    if (!given.empty())
        throw usage_error("the page of " + results + " has no use for it", given,
                          "results of a score or run");
}

ExitCode run(const PageOptions& options) {
    if (has_stress_results(options.results)) {
        require_no_options(options, "a stress test");
        print_path(write_stress_page(options.results));
        return ExitCode::ok;
    }
    if (has_tuning_record(options.results)) {
        require_no_options(options, "a tuning");
        print_path(write_tuning_page(options.results));
        return ExitCode::ok;
    }
    Outcome outcome(options.outcome);
    Results results = ranked_anew(read_results(options.results));
    const std::filesystem::path folder =
        std::filesystem::is_directory(options.results) ? options.results : options.results.parent_path();
    if (outcome.baseline()) {
        results.baseline = against_baseline(results, *outcome.baseline());
        write_results(results, folder);
    }
    // A page with everything differs from the one that a run would make.
    const std::string key = options.everything ? "" : page_key(results, std::string(code_digest("page")));
    print_path(write_page(results, folder, options.everything, key));
    return outcome.conclude(results);
}

}  // namespace

CommandEntry add_page_command(CLI::App& program, const GlobalOptions&) {
    CLI::App* app = program.add_subcommand(
        "page", "Make the page of earlier results again, without rendering; prints its path");
    app->alias("report");  // the earlier name, which scripts use
    const auto options = std::make_shared<PageOptions>();
    app->add_option(
           "results", options->results,
           "What run, score, stress or tune wrote: results with what lies beside them, or the folder")
        ->required();
    add_outcome_options(*app, options->outcome);
    add_baseline_option(*app, options->outcome);
    app->add_flag("--everything", options->everything,
                  "Keep raw outputs and the occlusion's causes in a large page too (a small one has them)");
    return {app, [options] { return run(*options); }};
}

}  // namespace aoscore
