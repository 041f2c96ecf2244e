#pragma once

#include "experiment/resolved_cell.h"
#include "reference/truth.h"
#include "results/results.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// What one view of a scene needs to be measured.
struct ViewRun {
    const Scene& scene;
    const View& view;
    const ReferenceScene& reference;
    ScreenRenderer& renderer;  ///< the scene is set already
    const ViewPlan& plan;
    std::vector<ResolvedCell> cells;
    std::string key;  ///< "atrium/wide"
    std::uint64_t seed = 1;
    double mask_threshold = 0.1;
    bool keep_gbuffer = true;
    std::filesystem::path truth_cache;  ///< empty: none
    std::string command;                ///< that makes the results again
    std::set<std::string> kept_inputs;  ///< of the G-buffer, in its file beside what the cells read
    std::filesystem::path folder;       ///< of the results; images go below it
};

struct ViewOutcome {
    ViewRecord view;
    std::vector<CellRecord> cells;  ///< in the order of ViewRun::cells
};

/// Truth, G-buffer, camera contract, then every cell: output, fetches, metrics; at last the clock, round by
/// round over all cells so that a disturbance of the machine meets all of them.
ViewOutcome run_view(const ViewRun& run);

}  // namespace aoscore
