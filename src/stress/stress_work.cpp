#include "stress/stress_work.h"

#include "core/error.h"

#include <algorithm>
#include <utility>

namespace aoscore {

StressWork::StressWork(const StressPlan& plan, const std::vector<StressSubject>& subjects, StressCase wanted,
                       StressJudgement judged_by, const std::string& key, SceneTools& tools)
    : stress(std::move(wanted)),
      judgement(judged_by),
      view{.scene = stress.scene,
           .view = stress.scene.views.front(),
           .tools = tools,
           .gl_renderer = tools.renderer().renderer(),
           .gl_version = tools.renderer().version(),
           .width = stress.width,
           .height = stress.height,
           .key = "stress " + key,
           .queries = {reference_query(stress)},
           .truth = {},
           .cells = {},
           .fixed_pass = {},
           .timing_goal = {},
           .seed = plan.seed,
           .keep_gbuffer = false,
           .kept_inputs = {},
           .truth_cache = {},
           .command = plan.command,
           .folder = {}} {
    view.radius_m = view.queries.front().radius_m;
    view.truth.samples = plan.samples;
    view.truth.seed = plan.seed;
    view.truth.extras.one_layer_bound = judgement == StressJudgement::error;
    add_requests(subjects, stress);
}

void StressWork::add_requests(const std::vector<StressSubject>& subjects, const StressCase& as_in) {
    for (const StressSubject& subject : subjects) {
        StressCell& cell = cells.emplace_back();
        cell.subject = subject.id;
        try {
            StressRequest request = stress_request(subject, judgement, as_in, view.seed);
            cell.skipped = request.skipped;
            if (!request.contestant) continue;
            if (std::ranges::find(view.queries, request.own) == view.queries.end())
                view.queries.push_back(request.own);
            view.cells.push_back({.id = view.key + "/" + subject.id,
                                  .contestant = request.contestant,
                                  .own = request.own,
                                  .keep_image = false,
                                  .timed = {}});
            requests.push_back(std::move(request));
        } catch (const Error& e) {
            cell.error = e.what();
        }
    }
}

}  // namespace aoscore
