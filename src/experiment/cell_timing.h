#pragma once

#include "experiment/resolved_cell.h"
#include "experiment/timing.h"
#include "screen/screen.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The timed runs of one cell, in the order they were taken.
struct CellTimes {
    std::vector<double> ao_ms;
    std::vector<double> filter_ms;                           ///< empty without a filter
    std::vector<double> lighting_ms;                         ///< empty without lighting
    std::vector<double> frame_at_once_ms, frame_by_pass_ms;  ///< empty where no whole frames are asked for
    std::string error;  ///< why the runs ended early; empty when they did not
};

/// Times the wanted cells on the renderer's current G-buffer: a warm-up each, then round by round over all of
/// them, so that a disturbance of the machine meets all alike; timed_runs() of each, or until `goal` is
/// reached. `what` names the work for its progress. Throws interrupted_error on Ctrl-C.
std::vector<CellTimes> time_cells(ScreenRenderer& renderer, const std::vector<ResolvedCell>& cells,
                                  const std::vector<bool>& wanted, const std::optional<TimingGoal>& goal,
                                  const std::string& what);

}  // namespace aoscore
