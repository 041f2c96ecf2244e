#include "jobs/view_jobs.h"

#include "jobs/view_keys.h"

#include <utility>

namespace aoscore {
namespace {

class Layout {
  public:
    explicit Layout(const ViewWork& work) : work_(work), keys_(work) {}

    ViewJobs lay_out() {
        if (work_.times_gbuffer())
            jobs_.gbuffer_times = want(keys_.gbuffer_times(), ArtifactKind::gbuffer_times, {});
        gbuffer_ = add(keys_.gbuffer(work_.drawn_inputs()), ArtifactKind::gbuffer, {});
        truth_ = add(keys_.truth(work_.queries), ArtifactKind::truth, {});
        if (!work_.own_queries.empty()) own_truth_ = add(keys_.own_truths(), ArtifactKind::own_truth, {});
        contract_ = add(keys_.contract(), ArtifactKind::contract, {gbuffer_, truth_});
        jobs_.view = want(keys_.view(), ArtifactKind::view, {truth_, contract_});
        if (work_.pictured()) {
            jobs_.truth_file = want(keys_.truth_file(), ArtifactKind::truth_file, {truth_, contract_});
            if (work_.keep_gbuffer)
                jobs_.gbuffer_file = want(keys_.gbuffer_file(), ArtifactKind::gbuffer_file, {gbuffer_});
        }
        if (work_.environment != nullptr) {
            irradiance_ = want(keys_.irradiance(), ArtifactKind::irradiance, {});
            jobs_.irradiance = irradiance_;
            jobs_.view_light =
                want(keys_.view_light(), ArtifactKind::view_light, {irradiance_, truth_, contract_});
        }
        for (std::size_t i = 0; i < work_.cells.size(); ++i) lay_out_cell(i);
        return std::move(jobs_);
    }

  private:
    Job job(Key key, ArtifactKind kind, std::vector<Key> inputs) const {
        Job job;
        job.key = std::move(key);
        job.kind = kind;
        job.about = work_.key;
        job.inputs = std::move(inputs);
        job.essential = true;
        return job;
    }
    Key add(Key key, ArtifactKind kind, std::vector<Key> inputs) {
        return jobs_.graph.add(job(std::move(key), kind, std::move(inputs))).key;
    }
    Key want(Key key, ArtifactKind kind, std::vector<Key> inputs) {
        return jobs_.graph.want(job(std::move(key), kind, std::move(inputs))).key;
    }

    void lay_out_cell(std::size_t i) {
        const CellWork& cell = work_.cells[i];
        const auto of_cell = [&](Key key, ArtifactKind kind, std::vector<Key> inputs) {
            Job made = job(std::move(key), kind, std::move(inputs));
            made.about = cell.id;
            made.cell = i;
            made.essential = false;
            return made;
        };
        CellKeys keys;
        Job image = of_cell(keys_.image(cell), ArtifactKind::image,
                            image_sources(*cell.contestant, gbuffer_, truth_));
        keys.image = (cell.keep_image ? jobs_.graph.want(image) : jobs_.graph.add(image)).key;
        keys.score =
            jobs_.graph.want(of_cell(keys_.score(cell), ArtifactKind::score, {keys.image, truth_, contract_}))
                .key;
        if (cell.own) {
            const Key& truth = work_.ranks_by(*cell.own) ? truth_ : own_truth_;
            Job own = of_cell(keys_.own_score(cell), ArtifactKind::own_score, {keys.image, truth, contract_});
            own.after = {keys.score};
            keys.own_score = jobs_.graph.want(own).key;
        }
        if (cell.lit_by_environment && work_.environment != nullptr) {
            const std::vector<Key> inputs{keys.image, irradiance_, truth_, contract_};
            Job light = of_cell(keys_.light(cell), ArtifactKind::light, inputs);
            light.after = {keys.score};
            keys.light = jobs_.graph.want(light).key;
            if (cell.keep_image) {
                Job file = of_cell(keys_.lit_file(cell), ArtifactKind::lit_file, inputs);
                file.after = {keys.score};
                keys.lit_file = jobs_.graph.want(file).key;
            }
        }
        if (cell.repeats && cell.contestant->timed_request() != nullptr) {
            Job repeats = of_cell(keys_.repeats(cell), ArtifactKind::repeats, {gbuffer_, truth_, contract_});
            repeats.after = {keys.score};
            keys.repeats = jobs_.graph.want(repeats).key;
        }
        if (work_.timed && cell.contestant->timed_request() != nullptr) {
            Job fetches = of_cell(keys_.fetches(cell), ArtifactKind::fetches, {gbuffer_, contract_});
            fetches.after = {keys.score};
            keys.fetches = jobs_.graph.want(fetches).key;
        }
        if (work_.timed && cell.wants_times && cell.contestant->timed_request() != nullptr) {
            Job times = of_cell(keys_.times(cell), ArtifactKind::times, {gbuffer_});
            times.after = {keys.score};
            times.in_turns = true;
            keys.times = jobs_.graph.want(times).key;
        }
        jobs_.cells.push_back(std::move(keys));
    }

    const ViewWork& work_;
    ViewKeys keys_;
    ViewJobs jobs_;
    Key gbuffer_, truth_, own_truth_, contract_, irradiance_;
};

}  // namespace

std::vector<Key> image_sources(const Contestant& contestant, const Key& gbuffer, const Key& truth) {
    std::vector<Key> sources;
    if (contestant.gbuffer_inputs()) sources.push_back(gbuffer);
    if (contestant.truth_query()) sources.push_back(truth);
    return sources;
}

ViewJobs view_jobs(const ViewWork& work) {
    return Layout(work).lay_out();
}

}  // namespace aoscore
