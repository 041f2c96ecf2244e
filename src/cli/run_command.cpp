#include "cli/command.h"
#include "cli/number_range.h"
#include "cli/run_and_page.h"
#include "cli/shared_options.h"
#include "core/log.h"
#include "plan/plan.h"
#include "results/results_folder.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <set>

namespace aoscore {
namespace {

struct RunOptions {
    std::vector<std::string> experiments;
    bool all = false;
    bool exact = false;
    std::optional<double> score_error;
    double scale = 1;
    std::filesystem::path out;
    OutcomeOptions outcome;
    std::filesystem::path truth_cache;
};

ExitCode run(const RunOptions& options, const GlobalOptions& global) {
    std::vector<std::string> ids = options.experiments;
    if (ids.empty()) {
        for (const ExperimentDefinition& experiment : list_experiments()) {
            if (options.all || experiment.kind != ExperimentDefinition::Kind::sweep)
                ids.push_back(experiment.id);
        }
    }
    ExperimentPlan plan = plan_experiments(ids, options.scale);
    for (ViewPlan& view : plan.views) {
        const bool measures_a_study = view.timing_goal || view.own_parameters;
        if (options.exact || measures_a_study) continue;
        view.score_goal.emplace();
        view.score_goal->error = options.score_error.value_or(view.score_goal->error);
    }
    plan.seed = global.seed;
    plan.command = global.command_line;
    plan.truth_cache = options.truth_cache;
    const std::filesystem::path folder = results_folder(options.out, "main");
    return run_and_page(std::move(plan), folder, options.outcome, global);
}

}  // namespace

CommandEntry add_run_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "run", "Rebuild published tables and sweeps: truth, methods, page (the main job)");
    const auto options = std::make_shared<RunOptions>();
    app->add_option(
        "experiment", options->experiments,
        "Experiments to run (see list experiments) [all tables, and the ranking of today's methods]");
    app->add_flag("--all", options->all, "All experiments, the sweeps too");
    app->add_flag(
        "--exact", options->exact,
        "Trace tables to the error that their definitions state, instead of as few rays as their scores "
        "need");
    add_score_error_option(*app, options->score_error)->excludes("--exact");
    app->add_option("--scale", options->scale, "Makes every picture this many times as wide and high")
        ->check(number_in(0.05, 8.0))
        ->capture_default_str();
    add_cache_option(*app, options->truth_cache);
    app->add_option("--out", options->out, "Folder of page, results and images [reports/out/main]");
    add_outcome_options(*app, options->outcome);
    add_job_options(*app, options->outcome.jobs);
    add_baseline_option(*app, options->outcome);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
