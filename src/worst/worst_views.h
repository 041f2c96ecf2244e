#pragma once

#include "plan/plan.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A search for the views of a scene on which a method errs most.
struct WorstPlan {
    CellPlan method;
    /// Where given, the views are those on which `method` is farthest behind this one.
    std::optional<CellPlan> rival;
    std::size_t cameras = 150;  ///< tried
    std::size_t views = 5;      ///< to be found
    std::optional<double> height_m;
    std::optional<double> radius_m;
    int width = 640, height = 360;  ///< of the pictures that confirm what small ones found
    int samples = 64;               ///< rays a pixel of their truths, even
    std::uint64_t seed = 1;
    std::filesystem::path truth_cache, methods_dir;
    std::string command;
};

struct FoundView {
    View view;
    double coarse = 0;     ///< by a small picture and few rays
    double confirmed = 0;  ///< by a larger one and more: the error, or how much larger it is than the rival's
};

struct WorstViews {
    double radius_m = 0;
    std::size_t tried = 0, judged = 0;
    bool inside = false;
    double median = 0;             ///< over all cameras that were judged, by small pictures
    std::size_t rival_won = 0;     ///< cameras on which the rival is closer; 0 without one
    std::vector<FoundView> views;  ///< the worst first; distinct, and fewer where there are no more
};

/// Searches. The worst that was found is not the worst that there is: cameras between those tried may be
/// worse. Throws gate_failed where no camera can be judged.
WorstViews find_worst_views(const WorstPlan& plan, const Scene& scene);

}  // namespace aoscore
