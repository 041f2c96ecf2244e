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
    times.ao_ms.push_back(run.ao_ms);
    times.ao_processor_ms.push_back(run.ao_processor_ms);
    if (run.layers_processor_ms) times.layers_processor_ms.push_back(*run.layers_processor_ms);
    if (run.filter_ms) times.filter_ms.push_back(*run.filter_ms);
    if (run.lighting_ms) times.lighting_ms.push_back(*run.lighting_ms);
    if (run.gbuffer_ms) times.gbuffer_ms.push_back(*run.gbuffer_ms);
}

// Times both kinds of frames. Their order changes from round to round, since one may warm caches for the
// other.
void time_whole_frames(ScreenRenderer& renderer, const MethodRequest& request, RequestTimes& times) {
    using Waits = ScreenRenderer::Waits;
    const auto at_once = [&] {
        times.frame_at_once_ms.push_back(renderer.time_frame(request, Waits::at_the_end));
    };
    const bool first = times.frame_by_pass_ms.size() % 2 == 0;
    if (first) at_once();
    times.frame_by_pass_ms.push_back(renderer.time_frame(request, Waits::after_every_pass));
    if (!first) at_once();
}

bool reached(const TimingGoal& goal, const RequestTimes& times) {
    for (const auto* runs_ms : {&times.ao_ms, &times.filter_ms, &times.lighting_ms, &times.frame_at_once_ms,
                                &times.frame_by_pass_ms}) {
        if (!runs_ms->empty() && !goal.reached(*runs_ms)) return false;
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
            const double warm_up_ms = renderer.time(requests[i].request).ao_ms;
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

std::vector<double> time_gbuffer(ScreenRenderer& renderer, double first_ms) {
    std::vector<double> runs_ms;
    for (int i = timed_runs(first_ms); i > 0; --i) runs_ms.push_back(renderer.time_gbuffer());
    return runs_ms;
}

}  // namespace aoscore
