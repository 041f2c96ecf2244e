#include "jobs/time_requests.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "jobs/timing.h"

#include <algorithm>
#include <numeric>

namespace aoscore {
namespace {

// When one cell fails, the others are still timed.
template <class Action>
bool succeeds(RequestTimes& times, Action action) {
    try {
        action();
        return true;
    } catch (const Error& e) {
        times.error = e.what();
        return false;
    }
}

void time_pass(ScreenRenderer& renderer, const MethodRequest& request, RequestTimes& times) {
    const ScreenRenderer::PassTimes run = renderer.time(request);
    times.ao.add(run.ao);
    if (run.layers_processor_ms) times.layers_processor_ms.push_back(*run.layers_processor_ms);
    if (run.filter) times.filter.add(*run.filter);
    if (run.lighting) times.lighting.add(*run.lighting);
    if (run.gbuffer) times.gbuffer.add(*run.gbuffer);
}

// Times both kinds of frames. Their order changes from round to round, since one may warm caches for the
// other.
void time_whole_frames(ScreenRenderer& renderer, const MethodRequest& request, RequestTimes& times) {
    using Waits = ScreenRenderer::Waits;
    const auto at_once = [&] { times.frame_at_once.add(renderer.time_frame(request, Waits::at_the_end)); };
    const bool first = times.frame_by_pass.ms.size() % 2 == 0;
    if (first) at_once();
    times.frame_by_pass.add(renderer.time_frame(request, Waits::after_every_pass));
    if (!first) at_once();
}

bool reached(const TimingGoal& goal, const RequestTimes& times) {
    for (const PassRuns* runs :
         {&times.ao, &times.filter, &times.lighting, &times.frame_at_once, &times.frame_by_pass}) {
        if (!runs->empty() && !goal.reached(runs->ms)) return false;
    }
    return true;
}

}  // namespace

std::vector<RequestTimes> time_requests(ScreenRenderer& renderer, const std::vector<TimedRequest>& requests,
                                        const std::optional<TimingGoal>& goal, const std::string& what) {
    std::vector<RequestTimes> times(requests.size());
    std::vector<int> runs_left(requests.size(), 0);
    for (std::size_t i = 0; i < requests.size(); ++i) {
        throw_if_interrupted();
        succeeds(times[i], [&] {
            const double warm_up_ms = renderer.time(requests[i].request).ao.ms;
            times[i].gbuffer_bytes = static_cast<double>(renderer.gbuffer_bytes(requests[i].request));
            runs_left[i] = goal ? goal->most : timed_runs(warm_up_ms);
        });
    }
    Progress progress(what, std::accumulate(runs_left.begin(), runs_left.end(), std::size_t{0}));
    while (std::any_of(runs_left.begin(), runs_left.end(), [](int left) { return left > 0; })) {
        for (std::size_t i = 0; i < requests.size(); ++i) {
            throw_if_interrupted();
            if (runs_left[i] == 0) continue;
            --runs_left[i];
            progress.step();
            const bool went_well = succeeds(times[i], [&] {
                time_pass(renderer, requests[i].request, times[i]);
                if (requests[i].whole_frames) time_whole_frames(renderer, requests[i].request, times[i]);
            });
            if (!went_well || (goal && reached(*goal, times[i]))) {
                progress.step(static_cast<std::size_t>(runs_left[i]));
                runs_left[i] = 0;
            }
        }
    }
    return times;
}

PassRuns time_gbuffer(ScreenRenderer& renderer, double first_ms) {
    PassRuns runs;
    for (int i = timed_runs(first_ms); i > 0; --i) runs.add(renderer.time_gbuffer());
    return runs;
}

}  // namespace aoscore
