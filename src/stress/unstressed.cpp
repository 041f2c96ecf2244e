#include "stress/unstressed.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "jobs/view_maker.h"
#include "stress/stress_jobs.h"
#include "stress/stressed_cell.h"

namespace aoscore {

Unstressed::Unstressed(const StressPlan& plan, const std::vector<StressSubject>& subjects, SceneTools& tools)
    : work_(plan, subjects, base_stress_case(plan.size), StressJudgement::error, "base", tools),
      keys_(work_.view) {
    StressCase performance = base_stress_case(plan.size);
    performance.performance_presets_only = true;
    work_.add_requests(subjects, performance);
    for (std::size_t i = 0; i < work_.requests.size(); ++i) cells_.emplace(name_of(work_.requests[i]), i);
}

Key Unstressed::key() const {
    KeyBuilder key("unstressed", "stress");
    for (const StressRequest& request : work_.requests) key.input(this->key(request));
    return key.key();
}

Key Unstressed::key(const StressRequest& request) const {
    const CellWork& cell = work_.view.cells[cells_.at(name_of(request))];
    KeyBuilder key("unstressed", "stress");
    return key.input(keys_.image(cell)).input(keys_.own_truth(*cell.own)).input(keys_.contract()).key();
}

void Unstressed::make(const ArtifactStore& store) {
    const ViewRecord described;
    ViewMaker maker(work_.view, {}, store, described);
    work_.view.tools.choose(work_.stress.scene);
    const SourceJobs jobs = source_jobs(work_, keys_);
    for (const Job& job : {jobs.gbuffer, jobs.truth, jobs.contract}) maker.make(job);
    for (std::size_t i = 0; i < work_.requests.size(); ++i) {
        throw_if_interrupted();
        const StressRequest& request = work_.requests[i];
        Made& made = pictures_[name_of(request)];
        try {
            maker.make(jobs.images[i]);
            StressCell cell;
            ImageF difference;
            const StressedPicture picture = stressed_picture(work_, request, maker);
            count_faults(picture, cell);
            compare_with_unstressed(work_.judgement, picture, {}, cell, difference);
            made.picture = {picture.visibility, picture.valid, cell.rmse, cell.mean};
        } catch (const Error& e) {
            if (e.exit_code() == ExitCode::interrupted) throw;
            made.error = e.what();
        }
    }
}

const UnstressedPicture& Unstressed::of(const StressRequest& request) const {
    const Made& made = pictures_.at(name_of(request));
    if (!made.error.empty()) throw internal_error(made.error);
    return made.picture;
}

}  // namespace aoscore
