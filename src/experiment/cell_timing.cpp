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
                const ScreenRenderer::PassTimes run = renderer.time(cells[i].request);
                times[i].ao_ms.push_back(run.ao_ms);
                if (run.filter_ms) times[i].filter_ms.push_back(*run.filter_ms);
            });
            const auto reached = [&](const std::vector<double>& runs_ms) {
                return runs_ms.empty() || goal->reached(runs_ms);
            };
            const bool enough = goal && reached(times[i].ao_ms) && reached(times[i].filter_ms);
            if (!went_well || enough) {
                progress.step(static_cast<std::size_t>(runs_left[i]));
                runs_left[i] = 0;
            }
        }
    }
    return times;
}

}  // namespace aoscore
