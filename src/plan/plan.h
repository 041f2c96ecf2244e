#pragma once

#include "jobs/contest/folder_image.h"
#include "jobs/timing.h"
#include "plan/run_modes.h"
#include "reference/truth.h"
#include "results/results.h"
#include "scene/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Before a filter's parameter among a cell's: "filter.taps".
inline constexpr std::string_view kFilterPrefix = "filter.";

/// One method as it is to be run on one view.
struct CellPlan {
    std::string method;
    std::string preset = "default";
    ParameterValues overrides;
    std::optional<std::string> filter;  ///< "none" or a filter's id; empty: the preset's own
    ParameterValues filter_overrides;
    RunModes modes;
    bool own_truth = false;  ///< also score it against the method's own radius and falloff
    bool keep_image = true;  ///< write its output
    /// Also time whole lit frames, waited for at their end and after every pass.
    bool whole_frames = false;
    /// Signals beside visibility that are scored, of those that the method gives (see core/signal.h).
    std::vector<std::string> signals = {};
    /// Whether both are the same measurement, whatever is kept of it.
    bool same_as(const CellPlan& other) const;
};

/// When a truth has rays enough: when the statements that are made with it are sure, not each of its pixels.
struct ScoreGoal {
    /// Half the width that the truth's noise may give the interval of a ranking's value.
    double error = 0.002;
    /// Also those of all other metrics that have one, within kOtherMetrics times of it; and passes are timed
    /// in full. Without it tracing also ends as soon as noise cannot change the order of a ranking.
    bool every_metric = true;

    static constexpr double kOtherMetrics = 5;
    /// Rays a pixel to begin with; they are doubled until the goal is reached.
    static constexpr int kFirstSamples = 16;
};

/// One view of a scene and everything that is run on it.
struct ViewPlan {
    std::string scene;  ///< built-in id or path of a glTF file
    LoadOptions load;   ///< how it is read, and with which views
    std::string view;   ///< as choose_views() takes it; of several views one after the other
    int width = 1920, height = 1080;
    double max_error = 0;                 ///< 0, or the standard error every truth pixel is traced to
    int samples = 64;                     ///< truth rays a pixel
    std::optional<ScoreGoal> score_goal;  ///< where given, decides the rays in place of the two above
    /// What else the truth is to tell about the ranking's occlusion: by default all that a page shows.
    TruthExtras extras{.causes = true, .one_layer_bound = true, .bent_normals = false};
    std::optional<double> radius_m;  ///< of the ranking; empty: the view's own, else one automatic
    /// Methods have the lengths of their descriptors, instead of being drawn for the view's radius: what
    /// publications state, or the user asked for.
    bool own_parameters = false;
    std::vector<CellPlan> cells;
    /// Timed until the median's interval is this narrow, where it is asked for.
    std::optional<TimingGoal> timing_goal;
    /// Draws what the lighting pass reads and times it, so that frames are known with their lighting.
    bool lit = false;
};

/// A published table to be rebuilt: its definition, and for each row the index of its cell.
struct TablePlan {
    nlohmann::json definition;
    std::size_t view_index = 0;             ///< into ExperimentPlan::views
    std::vector<std::size_t> cell_indices;  ///< into that view's cells
};

/// One setting of a sweep: a cell, and where it lies on the axes.
struct SweepPoint {
    std::size_t view_index = 0;  ///< into ExperimentPlan::views
    std::size_t cell_index = 0;  ///< into that view's cells
    ParameterValues at;          ///< value on each axis that applies, by the axis' id
};

/// Methods over the product of some axes.
struct SweepPlan {
    nlohmann::json definition;  ///< of an experiment; null when the command line asked
    std::string title;
    std::vector<std::string> axes;
    std::vector<SweepPoint> points;
    std::optional<double> budget_ms;  ///< of the AO pass with its filter
    std::vector<std::string> notes;   ///< what was left out, and why
};

/// Everything one run will measure.
struct ExperimentPlan {
    std::vector<ViewPlan> views;
    std::vector<TablePlan> tables;
    std::vector<SweepPlan> sweeps;
    std::vector<std::string> claim_ids;  ///< to be judged from what this run measures
    double claim_scale = 1;              ///< of the claims' views, as they were planned
    std::uint64_t seed = 1;
    std::filesystem::path methods_dir;  ///< of the user's own methods; empty: none
    std::vector<ImageFolder> folders;   ///< images of other programs that cells name
    std::filesystem::path
        truth_cache;           ///< folder of the truths and measurements that are kept; empty: none is
    bool keep_gbuffer = true;  ///< write the G-buffer beside the results
    /// An answer as soon as one stands: goals without ScoreGoal::every_metric, and nothing is timed. What was
    /// measured is kept, so that the whole plan goes on from there.
    bool first_answer = false;
    std::string command;                      ///< that makes it again
    std::shared_ptr<const Results> baseline;  ///< an earlier run to be held against; null: none
    std::vector<std::string> warnings;        ///< to be shown with the results
};

/// Whether rays of the plan are decided by what it is to find out.
bool has_score_goal(const ExperimentPlan& plan);
/// The plan that gives the first answer of `plan` (see ExperimentPlan::first_answer).
ExperimentPlan first_answer_of(ExperimentPlan plan);

/// The index of the plan's view of the same picture, added when there is none yet; the finer of both truths.
std::size_t shared_view(ExperimentPlan& plan, ViewPlan view);
/// The index of the same cell, added when there is none yet; what either keeps is kept.
std::size_t shared_cell(ViewPlan& view, CellPlan cell);

/// A method as a score draws it where nobody says how: with each preset that its descriptor names for scores,
/// in its modes. Throws file_error where these are none.
std::vector<CellPlan> scored_cells(const MethodDescriptor& method);

/// An experiment of a publication, or of ours: one file of reports/.
struct ExperimentDefinition {
    enum class Kind { table, ranking, sweep };
    Kind kind = Kind::table;
    std::string id;
    std::string title;
    std::string source;  ///< author, title, year; empty for a ranking
    std::filesystem::path file;
};
/// All of reports/*.json, by id.
std::vector<ExperimentDefinition> list_experiments();

/// Merges the definitions of these experiments into one plan: a view that several tables show is traced once,
/// a cell that several rows name is run once. A ranking adds methods to a scene's views, as `score` draws
/// them. Pictures are made `scale` times as wide and high as the definitions say. A sweep also measures what
/// the claims that it lists ask for, in pictures of their own size. In both, methods keep their own lengths,
/// as published. Throws usage_error for an unknown id (listing the known ones), file_error for a bad
/// definition.
ExperimentPlan plan_experiments(const std::vector<std::string>& ids, double scale = 1);

}  // namespace aoscore
