#include "jobs/view_record.h"

#include "jobs/truth_provenance.h"
#include "jobs/truth_record.h"

#include <vector>

namespace aoscore {

ViewRecord recorded_view(const ViewWork& work, const ViewRecord& described, const CachedTruth& traced,
                         const Ground& ground) {
    ViewRecord view = described;
    view.truth_origin = origin_id(traced.origin);
    view.least_samples = traced.made_for.settings.samples;
    view.halves = traced.made_for.settings.halves;
    if (traced.origin == TruthOrigin::given) {
        view.halves = !traced.truth.halves.empty();
        record_ground(ground, work.frame(), traced.truth, work.radius_m, view);
        record_truth(traced.truth, ground.contract.valid, view);
        return view;
    }
    view.integrator = integrator_id();
    TruthRequest again = traced.made_for;
    again.queries = work.queries;
    std::erase_if(again.queries, [](const TruthQuery& query) { return query.falloff != Falloff::binary; });
    view.truth_command = reference_command(work.scene, work.view, again, file_name(work.key) + "-truth.exr");
    if (traced.made_for.settings.max_error > 0) view.max_error = traced.made_for.settings.max_error;
    record_ground(ground, work.frame(), traced.truth, work.radius_m, view);
    record_truth(traced.truth, ground.contract.valid, view);
    return view;
}

}  // namespace aoscore
