#pragma once

#include "experiment/measurement_store.h"
#include "experiment/ranking_radius.h"
#include "experiment/resolved_cell.h"
#include "experiment/scene_tools.h"
#include "results/results.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

struct ViewStock;

/// What one view of a scene needs to be measured.
struct ViewRun {
    const Scene& scene;
    const View& view;
    SceneTools& tools;  ///< `scene` is chosen
    const ViewPlan& plan;
    RankingRadius radius;
    std::optional<double> drawn_for_m;  ///< AO radius of all lengths; empty: they are the descriptors' own
    std::vector<ResolvedCell> cells;
    const MethodDescriptor& fixed_pass;  ///< timed among the cells
    const MethodDescriptor& lighting;    ///< timed after it where the plan is lit
    std::string key;                     ///< "atrium/wide"
    std::uint64_t seed = 1;
    double mask_threshold = 0.1;
    bool keep_gbuffer = true;
    std::filesystem::path truth_cache;  ///< empty: none
    std::string command;                ///< that makes the results again
    std::set<std::string> kept_inputs;  ///< of the G-buffer, in its file beside what the cells read
    std::filesystem::path folder;       ///< of the results; images go below it

    /// Whether a cell keeps its image; then the view keeps its own.
    bool pictured() const;
    /// Whether what a frame costs without AO is asked for: by pictures, and by timings to a goal.
    bool times_gbuffer() const;
    /// The G-buffer inputs that the cells read, and the lighting where the plan is lit.
    std::set<std::string> read_inputs() const;
    /// The fixed pass, lit where the plan is.
    MethodRequest fixed_pass_request() const;
};

struct ViewOutcome {
    ViewRecord view;
    std::vector<CellRecord> cells;  ///< in the order of ViewRun::cells
    std::uint64_t rays = 0;         ///< traced now
    std::size_t measured = 0;       ///< cells that were not in the store
};

/// Takes from the store what is there, and measures the rest: truth, G-buffer, camera contract, then every
/// cell's output, fetches and metrics; at last the clock, round by round over the cells, so that a
/// disturbance of the machine meets all of them. Each measurement is put into the store as soon as it is
/// made: an interrupted run continues where it stopped.
ViewOutcome run_view(const ViewRun& run, const MeasurementStore& store, const ViewStock& stock);

}  // namespace aoscore
