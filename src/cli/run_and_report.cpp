#include "cli/run_and_report.h"

#include "core/output.h"
#include "experiment/experiment.h"
#include "experiment/job_list.h"
#include "report/report.h"

namespace aoscore {

ExitCode run_and_report(ExperimentPlan plan, const std::filesystem::path& folder,
                        const OutcomeOptions& options, const GlobalOptions& global) {
    if (options.list_jobs) {
        print_result("{}\n", list_jobs(plan, global.words).dump(2));
        return ExitCode::ok;
    }
    if (!options.only_job.empty()) {
        make_job(plan, options.only_job);
        return ExitCode::ok;
    }
    require_page_parts();
    Outcome outcome(options);
    plan.baseline = outcome.baseline();
    std::filesystem::path page;
    const Results results = run_experiment(plan, folder, [&](const std::filesystem::path& staged) {
        page = folder / write_report(staged).filename();
    });
    print_path(page);
    return outcome.conclude(results);
}

}  // namespace aoscore
