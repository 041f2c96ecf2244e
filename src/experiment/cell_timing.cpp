#include "experiment/cell_timing.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "experiment/timing.h"

#include <algorithm>
#include <numeric>

namespace aoscore {
namespace {

// Whatever goes wrong with one cell, the others are still timed.
template <class Action>
bool succeeds(CellTimes& times, Action action) {
    try {
        action();
        return true;
    } catch (const Error& e) {
        times.error = e.what();
        return false;
    }
}

void time_pass(ScreenRenderer& renderer, const MethodRequest& request, CellTimes& times) {
    const ScreenRenderer::PassTimes run = renderer.time(request);
    times.ao_ms.push_back(run.ao_ms);
    if (run.filter_ms) times.filter_ms.push_back(*run.filter_ms);
    if (run.lighting_ms) times.lighting_ms.push_back(*run.lighting_ms);
}

// Which of the two comes first changes from round to round: what one leaves behind may help the other.
void time_whole_frames(ScreenRenderer& renderer, const MethodRequest& request, CellTimes& times) {
    using Waits = ScreenRenderer::Waits;
    const auto at_once = [&] {
        times.frame_at_once_ms.push_back(renderer.time_frame(request, Waits::at_the_end));
    };
    const bool first = times.frame_by_pass_ms.size() % 2 == 0;
    if (first) at_once();
    times.frame_by_pass_ms.push_back(renderer.time_frame(request, Waits::after_every_pass));
    if (!first) at_once();
}

bool reached(const TimingGoal& goal, const CellTimes& times) {
    for (const auto* runs_ms : {&times.ao_ms, &times.filter_ms, &times.lighting_ms, &times.frame_at_once_ms,
                                &times.frame_by_pass_ms}) {
        if (!runs_ms->empty() && !goal.reached(*runs_ms)) return false;
    }
    return true;
}

}  // namespace

std::vector<CellTimes> time_cells(ScreenRenderer& renderer, const std::vector<ResolvedCell>& cells,
                                  const std::vector<bool>& wanted, const std::optional<TimingGoal>& goal,
                                  const std::string& what) {
    std::vector<CellTimes> times(cells.size());
    std::vector<int> runs_left(cells.size(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        throw_if_interrupted();
        if (!wanted[i]) continue;
        succeeds(times[i], [&] {
            const double warm_up_ms = renderer.time(cells[i].request).ao_ms;
            runs_left[i] = goal ? goal->most : timed_runs(warm_up_ms);
        });
    }
    Progress progress(what, std::accumulate(runs_left.begin(), runs_left.end(), std::size_t{0}));
    while (std::any_of(runs_left.begin(), runs_left.end(), [](int left) { return left > 0; })) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            throw_if_interrupted();
            if (runs_left[i] == 0) continue;
            --runs_left[i];
            progress.step();
            const bool went_well = succeeds(times[i], [&] {
                time_pass(renderer, cells[i].request, times[i]);
                if (cells[i].plan.whole_frames) time_whole_frames(renderer, cells[i].request, times[i]);
            });
            if (!went_well || (goal && reached(*goal, times[i]))) {
                progress.step(static_cast<std::size_t>(runs_left[i]));
                runs_left[i] = 0;
            }
        }
    }
    return times;
}

}  // namespace aoscore
