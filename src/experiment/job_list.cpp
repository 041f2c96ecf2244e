#include "experiment/job_list.h"

#include "core/temporary_folder.h"
#include "experiment/planned_runs.h"
#include "jobs/job_cost.h"
#include "jobs/job_listing.h"
#include "jobs/view_maker.h"
#include "store/artifact_store.h"

namespace aoscore {
namespace {

ArtifactStore store_of(const ExperimentPlan& plan) {
    return ArtifactStore(ArtifactStore::folder_in(plan.truth_cache));
}

}  // namespace

nlohmann::json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments) {
    const ArtifactStore store = store_of(plan);
    PlannedRuns planned(plan, store);
    planned.lay_out({});
    JobListing listing(store, arguments);
    for (const ViewRun& run : planned.runs()) {
        listing.add(run.jobs.graph, [&](const Job& job) { return estimated_cost_s(job, run.work); });
    }
    return listing.json();
}

std::size_t make_jobs(const ExperimentPlan& plan, const std::vector<std::string>& keys) {
    const ArtifactStore store = store_of(plan);
    ChosenJobs chosen(keys, store);
    PlannedRuns planned(plan, store);
    const TemporaryFolder folder;
    planned.lay_out(folder.path());
    for (const ViewRun& run : planned.runs()) {
        if (!chosen.any_in(run.jobs.graph)) continue;
        planned.tools().choose(run.work.scene);
        const ViewRecord described = described_view(run);
        ViewMaker maker(run.work, run.jobs, store, described);
        chosen.make(run.jobs.graph, maker);
    }
    return chosen.failed();
}

}  // namespace aoscore
