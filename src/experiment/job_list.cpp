#include "experiment/job_list.h"

#include "core/temporary_folder.h"
#include "experiment/planned_runs.h"
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
    for (const ViewRun& run : planned.runs()) listing.add(run.jobs.graph);
    return listing.json();
}

void make_job(const ExperimentPlan& plan, const std::string& key) {
    const ArtifactStore store = store_of(plan);
    PlannedRuns planned(plan, store);
    const TemporaryFolder folder;
    planned.lay_out(folder.path());
    for (const ViewRun& run : planned.runs()) {
        if (!has_job_to_make(run.jobs.graph, key, store)) continue;
        planned.tools().choose(run.work.scene);
        const ViewRecord described = described_view(run);
        ViewMaker maker(run.work, run.jobs, store, described);
        return make_alone(run.jobs.graph, key, maker);
    }
    throw_no_such_job(key);
}

}  // namespace aoscore
