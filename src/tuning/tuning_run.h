#pragma once

#include "metrics/roles.h"
#include "plan/resolved_cell.h"
#include "tuning/tuned_method.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Everything that one run of tuning needs.
struct TuningPlan {
    struct OnScene {
        std::string scene;               ///< built-in id or path
        LoadOptions load;                ///< options for reading the scene and its views
        std::vector<std::string> views;  ///< choices for choose_views()
    };
    struct Method {
        CellPlan cell;                            ///< with the preset to begin from
        std::vector<std::string> parameters;      ///< to tune; empty: see search_axes()
        std::optional<SearchEffort> effort = {};  ///< in place of the plan's
    };
    std::vector<OnScene> scenes;
    std::vector<Method> methods;
    std::string metric = kRankingMetric;
    std::vector<Budget> budgets = {{}};  ///< each tuned by itself
    SearchEffort effort;
    int width = 640, height = 360;
    int samples = 64;  ///< truth's rays a pixel, even
    std::optional<double> radius_m;
    bool in_sample = false;  ///< one view suffices: nothing is left out
    std::uint64_t seed = 1;
    std::filesystem::path truth_cache, methods_dir;
    std::string command;
    std::string definition;  ///< the id of the definition that the plan was read from; empty: none
};

/// A method's tuning, for every budget.
struct MethodTuning {
    CellPlan cell;
    std::string label;
    std::vector<SearchAxis> axes;
    std::vector<TunedMethod> budgets;
    std::size_t drawn = 0, reused = 0;  ///< images drawn, and those that were measured before
};

struct TuningResults {
    std::vector<std::string> views;  ///< keys
    std::vector<double> radii_m;
    std::vector<MethodTuning> methods;
};

/// Makes all views ready, and tunes every method on them. Throws usage_error for one view alone without
/// `in_sample`.
TuningResults tune(const TuningPlan& plan);

/// Writes tune.json (results/tuning_record.h), and for every method METHOD.tuned.json, which --preset takes.
void write_tuning(const TuningResults& results, const TuningPlan& plan, const std::filesystem::path& folder);

/// Prints the tables.
void print_tuning(const TuningResults& results, const TuningPlan& plan);

}  // namespace aoscore
