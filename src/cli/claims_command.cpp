#include "cli/command.h"
#include "cli/number_range.h"
#include "cli/run_and_page.h"
#include "cli/shared_options.h"
#include "core/error.h"
#include "core/output.h"
#include "results/results_folder.h"
#include "verdict/claim_verdicts.h"

#include <memory>
#include <optional>

namespace aoscore {
namespace {

struct ClaimsOptions {
    std::vector<std::string> ids;
    double scale = 1;
    std::filesystem::path truth_cache;
    std::filesystem::path out;
    std::filesystem::path before;  ///< results.json of an earlier run; empty: none
    OutcomeOptions outcome;
};

ExitCode run(const ClaimsOptions& options, const GlobalOptions& global) {
    std::optional<Results> before;
    if (!options.before.empty()) {
        before = read_results(options.before);
        if (before->claims.empty())
            throw file_error("judges no claims", options.before.string(), "results of aoscore claims");
    }
    std::vector<ClaimList> lists = chosen_claims(load_claims(), options.ids);
    scale_views(lists, options.scale);
    ExperimentPlan plan;
    plan.seed = global.seed;
    plan.truth_cache = options.truth_cache;
    plan.command = global.command_line;
    plan.keep_gbuffer = false;
    plan.claim_scale = options.scale;
    plan_claims(plan, lists);
    for (const ClaimList& list : lists) {
        for (const Claim& claim : list.claims) plan.claim_ids.push_back(claim.id);
    }
    const auto print_verdicts = [&before](const Results& results) {
        print_result("{}", verdict_table(results.claims));
        if (before) print_result("{}", changed_verdicts(results, *before));
    };
    return run_and_page(plan, results_folder(options.out, "claims"), options.outcome, global, print_verdicts);
}

}  // namespace

CommandEntry add_claims_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand("claims",
                                           "Measure what the published claims of reports/claims/ state, and "
                                           "say which hold; prints the page's path");
    const auto options = std::make_shared<ClaimsOptions>();
    app->add_option("id", options->ids,
                    "Claims to judge, such as H01, or a file of them, such as field [all]");
    app->add_option("--scale", options->scale, "Makes every picture this many times as wide and high")
        ->check(number_in(0.05, 8.0))
        ->capture_default_str();
    add_cache_option(*app, options->truth_cache);
    app->add_option("--before", options->before,
                    "results.json of an earlier run: also print which verdicts have changed since");
    app->add_option("--out", options->out, "Folder of page and results [reports/out/claims]");
    add_outcome_options(*app, options->outcome);
    add_job_options(*app, options->outcome.jobs);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
