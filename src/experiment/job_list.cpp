#include "experiment/job_list.h"

#include "core/error.h"
#include "core/log.h"
#include "core/temporary_folder.h"
#include "experiment/planned_runs.h"
#include "jobs/executor.h"
#include "jobs/view_maker.h"
#include "store/artifact_store.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {
namespace {

using nlohmann::json;

std::string description_key(const std::string& job) {
    return Digest().text("job").text(job).hex();
}

ArtifactStore store_in(const std::filesystem::path& cache) {
    return ArtifactStore(ArtifactStore::folder_in(cache));
}

json hex_of(const std::vector<Key>& keys) {
    json list = json::array();
    for (const Key& key : keys) list.push_back(key.hex);
    return list;
}

bool is_kept(ArtifactKind kind) {
    return kind != ArtifactKind::gbuffer && kind != ArtifactKind::contract;
}

/// Whether it lies in the store under its key; truths lie there by the tile.
bool has_entry(ArtifactKind kind) {
    return is_kept(kind) && kind != ArtifactKind::truth && kind != ArtifactKind::own_truth;
}

JobGraph only(const JobGraph& graph, const Key& key) {
    JobGraph part;
    for (const Job& job : graph.jobs()) {
        if (job.key == key) {
            part.want(job);
        } else {
            part.add(job);
        }
    }
    return part;
}

}  // namespace

json list_jobs(const ExperimentPlan& plan, const std::vector<std::string>& arguments) {
    const ArtifactStore store = store_in(plan.truth_cache);
    PlannedRuns planned(plan, store);
    planned.lay_out({});
    json jobs = json::array();
    for (const ViewRun& run : planned.runs()) {
        const auto wanted = run.jobs.graph.wanted();
        for (const Job& job : run.jobs.graph.jobs()) {
            jobs.push_back({{"key", job.key.hex},
                            {"kind", id_of(job.kind)},
                            {"about", job.about},
                            {"inputs", hex_of(job.inputs)},
                            {"after", hex_of(job.after)},
                            {"asked", std::ranges::find(wanted, job.key) != wanted.end()},
                            {"known", has_entry(job.kind) ? json(store.has(job.key.hex)) : json()}});
            store.put(description_key(job.key.hex), {{"arguments", arguments}});
        }
    }
    return {{"jobs", std::move(jobs)}};
}

std::vector<std::string> arguments_of_job(const std::string& key, const std::filesystem::path& cache) {
    const std::optional<json> found = store_in(cache).find(description_key(key));
    if (!found) {
        throw usage_error("no command has listed the job " + key, "KEY",
                          "a key that --jobs has printed, with the same cache");
    }
    return found->at("arguments").get<std::vector<std::string>>();
}

void make_job(const ExperimentPlan& plan, const std::string& key) {
    const ArtifactStore store = store_in(plan.truth_cache);
    if (!store.enabled())
        throw usage_error("a single job needs a store to put its artifact in", "--no-cache");
    PlannedRuns planned(plan, store);
    const TemporaryFolder folder;
    planned.lay_out(folder.path());
    for (const ViewRun& run : planned.runs()) {
        if (!run.jobs.graph.contains({key})) continue;
        const Job& job = run.jobs.graph.at({key});
        if (!is_kept(job.kind)) {
            throw usage_error(
                fmt::format("a {} is not kept: it is made wherever it is needed", id_of(job.kind)), key,
                "the key of another kind of job");
        }
        planned.tools().choose(run.work.scene);
        const ViewRecord described = described_view(run);
        ViewMaker maker(run.work, run.jobs, store, described);
        const Execution done = execute(only(run.jobs.graph, job.key), maker);
        if (done.has_failed(job.key)) throw internal_error(done.failed.at(job.key), job.about);
        log_info(fmt::format("{} of {}: {}", id_of(job.kind), job.about,
                             done.taken.empty() ? "made" : "was there"));
        return;
    }
    throw usage_error("the command has no job " + key, "KEY", "a key that --jobs prints for it");
}

}  // namespace aoscore
