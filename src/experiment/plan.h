#pragma once

#include "experiment/run_modes.h"
#include "reference/truth.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// One method as it is to be run on one view.
struct CellPlan {
    std::string method;
    std::string preset = "default";
    ParameterValues overrides;
    std::optional<std::string> filter;  ///< "none" or a filter's id; empty: the preset's own
    RunModes modes;
    bool operator==(const CellPlan&) const = default;
};

/// One view of a scene and everything that is run on it.
struct ViewPlan {
    std::string scene;  ///< built-in id or path of a glTF file
    std::string view;   ///< empty: every view of the scene, one after the other
    int width = 1920, height = 1080;
    double max_error = 0;  ///< 0, or the standard error every truth pixel is traced to
    int samples = 64;      ///< truth rays a pixel
    /// What else the truth is to tell about the ranking's occlusion: by default all that a page shows.
    TruthExtras extras{.causes = true, .one_layer_bound = true, .bent_normals = false};
    std::optional<double> radius_m;  ///< of the ranking; empty: the view's own, else one automatic
    std::vector<CellPlan> cells;
};

/// A published table to be rebuilt: its definition, and for each row the index of its cell.
struct TablePlan {
    nlohmann::json definition;
    std::size_t view_index = 0;             ///< into ExperimentPlan::views
    std::vector<std::size_t> cell_indices;  ///< into that view's cells
};

/// Everything one run will measure.
struct ExperimentPlan {
    std::vector<ViewPlan> views;
    std::vector<TablePlan> tables;
    std::uint64_t seed = 1;
    std::filesystem::path methods_dir;  ///< of the user's own methods; empty: none
    std::filesystem::path truth_cache;  ///< folder of the truths that are kept; empty: all are traced anew
    bool keep_gbuffer = true;           ///< write the G-buffer beside the results
    std::string command;                ///< that makes it again
    std::shared_ptr<const Results> baseline;  ///< an earlier run to be held against; null: none
    std::vector<std::string> warnings;        ///< to be shown with the results
};

/// A report definition: one file of reports/.
struct ReportDefinition {
    std::string id;
    std::string title;
    std::string source;  ///< author, title, year
    std::filesystem::path file;
};
/// All of reports/*.json, by id.
std::vector<ReportDefinition> list_reports();

/// Merges the definitions of these reports into one plan: a view that several tables show is traced once, a
/// cell that several rows name is run once. Throws usage_error for an unknown id (listing the known ones),
/// file_error for a bad definition.
ExperimentPlan plan_reports(const std::vector<std::string>& report_ids);

}  // namespace aoscore
