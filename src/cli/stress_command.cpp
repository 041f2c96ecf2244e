#include "cli/command.h"
#include "cli/job_options.h"
#include "cli/shared_options.h"
#include "core/output.h"
#include "page/stress_page.h"
#include "results/results_folder.h"
#include "stress/stress.h"
#include "stress/stress_job_list.h"

#include <memory>

namespace aoscore {
namespace {

struct StressOptions {
    StressPlan plan;
    bool quick = false;
    JobOptions jobs;
    std::filesystem::path out;
};

ExitCode run(const StressOptions& options, const GlobalOptions& global) {
    StressPlan plan = options.plan;
    plan.seed = global.seed;
    plan.command = global.command_line;
    if (options.quick) {
        plan.ends_only = true;
        plan.size = 64;
        plan.samples = 16;
    }
    if (const auto code = list_or_make_some(
            options.jobs, global.words,
            [&](const std::vector<std::string>& words) { return list_stress_jobs(plan, words); },
            [&](const std::vector<std::string>& keys) { return make_stress_jobs(plan, keys); }))
        return *code;
    const std::filesystem::path folder = results_folder(options.out, "stress");
    const StressResults results = run_stress(plan, folder);
    print_path(write_stress_page(folder));
    return failed_cells(results) > 0 ? ExitCode::cells_failed : ExitCode::ok;
}

}  // namespace

CommandEntry add_stress_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "stress", "Try methods, filters and reference at extreme numbers; prints the page's path");
    const auto options = std::make_shared<StressOptions>();
    app->add_option("--methods", options->plan.methods, "Methods to try (see list methods) [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--axes", options->plan.axes, "Kinds of stress [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--methods-dir", options->plan.methods_dir, "A folder of methods of your own");
    app->add_flag("--quick", options->quick, "The ends of each axis alone, in 64x64 pixels");
    add_job_options(*app, options->jobs);
    add_cache_option(*app, options->plan.cache);
    app->add_option("--out", options->out, "Folder of page, results and images [reports/out/stress]");
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
