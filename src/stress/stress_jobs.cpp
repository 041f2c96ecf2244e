#include "stress/stress_jobs.h"

#include "core/node_kind.h"
#include "jobs/view_jobs.h"
#include "store/code_digest.h"

#include <optional>
#include <utility>

namespace aoscore {
namespace {

Job job_of(const StressWork& work, Key key, ArtifactKind kind, std::vector<Key> inputs, bool essential) {
    Job job;
    job.key = std::move(key);
    job.kind = kind;
    job.about = work.view.key;
    job.inputs = std::move(inputs);
    job.essential = essential;
    return job;
}

Job cell_job(const StressWork& work, Key key, ArtifactKind kind, std::vector<Key> inputs, std::size_t i) {
    Job job = job_of(work, std::move(key), kind, std::move(inputs), false);
    job.about = work.view.cells[i].id;
    job.cell = i;
    return job;
}

// Begins the key of times, which a machine of another kind leaves out.
KeyBuilder timed(std::string_view kind) {
    KeyBuilder key(kind, "stress");
    key.text(code_digest("times")).text(timed_on());
    return key;
}

Key setting_key(const StressWork& work, const ViewKeys& keys) {
    KeyBuilder key("stress_setting", "stress");
    key.input(keys.gbuffer(work.view.drawn_inputs())).value(work.stress.has_truth);
    if (work.stress.has_truth) key.input(keys.truth(work.view.queries)).input(keys.contract());
    return key.key();
}

Key cell_key(const StressWork& work, const ViewKeys& keys, std::size_t i, const Unstressed& unstressed) {
    const CellWork& cell = work.view.cells[i];
    KeyBuilder key("stress_cell", "stress");
    key.text(work.requests[i].subject->id).input(keys.image(cell)).input(unstressed.key(work.requests[i]));
    key.value(work.judgement).value(work.stress.has_truth);
    if (work.stress.has_truth) key.input(keys.own_truth(*cell.own)).input(keys.contract());
    return key.key();
}

// The reference's time is that of its truth.
bool is_timed(const StressRequest& request) {
    return request.contestant->timed_request() != nullptr || request.subject->kind == "reference";
}

}  // namespace

SourceJobs source_jobs(const StressWork& work, const ViewKeys& keys) {
    SourceJobs jobs;
    jobs.gbuffer = job_of(work, keys.gbuffer(work.view.drawn_inputs()), ArtifactKind::gbuffer, {}, true);
    jobs.truth = job_of(work, keys.truth(work.view.queries), ArtifactKind::truth, {}, true);
    jobs.contract =
        job_of(work, keys.contract(), ArtifactKind::contract, {jobs.gbuffer.key, jobs.truth.key}, true);
    for (std::size_t i = 0; i < work.requests.size(); ++i) {
        const CellWork& cell = work.view.cells[i];
        jobs.images.push_back(cell_job(work, keys.image(cell), ArtifactKind::image,
                                       image_sources(*cell.contestant, jobs.gbuffer.key, jobs.truth.key), i));
    }
    return jobs;
}

StressJobs stress_jobs(const StressWork& work, const Unstressed& unstressed) {
    StressJobs jobs;
    JobGraph& graph = jobs.graph;
    const ViewKeys keys(work.view);
    const SourceJobs sources = source_jobs(work, keys);
    std::vector<Key> ground{graph.add(job_of(work, unstressed.key(), ArtifactKind::unstressed, {}, true)).key,
                            graph.add(sources.gbuffer).key};
    if (work.stress.has_truth) {
        ground.push_back(graph.add(sources.truth).key);
        ground.push_back(graph.add(sources.contract).key);
    }
    jobs.setting =
        graph.want(job_of(work, setting_key(work, keys), ArtifactKind::stress_setting, ground, true)).key;
    const Key drawn_ms = timed("stress_gbuffer_times").input(sources.gbuffer.key).key();
    jobs.gbuffer_times =
        graph.want(job_of(work, drawn_ms, ArtifactKind::gbuffer_times, {sources.gbuffer.key}, true)).key;
    for (std::size_t i = 0; i < work.requests.size(); ++i) {
        std::vector<Key> inputs = ground;
        inputs.push_back(graph.add(sources.images[i]).key);
        const Key cell = cell_key(work, keys, i, unstressed);
        jobs.cells.push_back(
            graph.want(cell_job(work, cell, ArtifactKind::stress_cell, std::move(inputs), i)).key);
        std::optional<Key>& times = jobs.times.emplace_back();
        if (!is_timed(work.requests[i])) continue;
        Job job = cell_job(work, timed("stress_times").input(cell).key(), ArtifactKind::times,
                           {sources.gbuffer.key, sources.images[i].key}, i);
        job.after = {cell};
        times = graph.want(std::move(job)).key;
    }
    return jobs;
}

}  // namespace aoscore
