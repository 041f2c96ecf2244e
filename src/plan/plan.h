#pragma once

#include "core/environment.h"
#include "jobs/contest/outside_method.h"
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

struct RecordedView;

/// The prefix of a filter's parameter among a cell's: "filter.taps".
inline constexpr std::string_view kFilterPrefix = "filter.";

/// One method with its settings on one view.
struct CellPlan {
    std::string method;
    std::string preset = "default";
    ParameterValues overrides;
    std::optional<std::string> filter;  ///< "none" or a filter's id; empty: the preset's own
    ParameterValues filter_overrides;
    RunModes modes;
    bool own_truth = false;  ///< also scored against the method's own radius and falloff
    bool keep_image = true;  ///< write its output
    bool timed = true;       ///< its passes are timed
    /// Whole lit frames are timed too, with a wait at their end and with one after every pass.
    bool whole_frames = false;
    /// The method's lengths follow so many times the view's radius; what the view is ranked by does not.
    double radius_factor = 1;
    bool step = false;  ///< measured for advice alone: it stands in no table, ranking or gate
    /// It is drawn again with other seeds, and held against what one depth layer hides (jobs/repeats.h).
    bool repeats = false;
    /// Changes of its parameters that make it its own converged picture, against which it is held with its
    /// repeats; empty: it is not.
    ParameterValues converged = {};
    /// What it lights a surface with under the view's environment is held against ray-traced irradiance.
    bool lit_by_environment = false;
    /// Added to the run's seed, for other random kernels and noise.
    int draw = 0;
    /// Signals beside visibility to score where the method gives them (see core/signal.h).
    std::vector<std::string> signals = {};
    /// Whether both are the same measurement, whatever files it leaves.
    bool same_as(const CellPlan& other) const;
};

/// Says when a truth has enough rays: when the scores are certain, rather than each of its pixels.
struct ScoreGoal {
    /// The half width that the truth's noise may give the interval of a ranking's value.
    double error = 0.002;
    /// The intervals of all other metrics must also be within kOtherMetrics times that width, and passes are
    /// timed in full. Without it tracing also ends as soon as noise cannot change the order of a ranking.
    bool every_metric = true;

    static constexpr double kOtherMetrics = 5;
    /// The first number of rays a pixel, then more until the goal is reached.
    static constexpr int kFirstSamples = 16;
};

/// One view of a scene with its cells.
struct ViewPlan {
    std::string scene;  ///< built-in id or path of a glTF file
    LoadOptions load;   ///< options for reading the scene and its views
    std::string view;   ///< a choice for choose_views(); several views run one by one
    std::shared_ptr<const RecordedView> recorded;  ///< in place of a scene: a frame and its truth; else null
    int width = 1920, height = 1080;
    double max_error = 0;                 ///< standard error to trace every truth pixel to; 0: by samples
    int samples = 64;                     ///< truth rays a pixel
    std::optional<ScoreGoal> score_goal;  ///< replaces the two above where given
    /// Further data of the truth about the ranking's occlusion: by default all that a page shows.
    TruthExtras extras{.causes = true, .one_layer_bound = true, .bent_normals = false};
    std::optional<double> radius_m;  ///< of the ranking; empty: the view's own, else automatic
    /// Methods keep their descriptors' lengths, as published, instead of following the view's radius.
    bool own_parameters = false;
    /// What cells are lit by; null: the generated sky.
    std::shared_ptr<const Environment> environment = nullptr;
    std::vector<CellPlan> cells;
    /// Where given, passes are timed until the median's interval is this narrow.
    std::optional<TimingGoal> timing_goal;
    /// The lighting pass is drawn and timed with its inputs, so that whole frames are known.
    bool lit = false;
};

/// One setting of a sweep: a cell, and its values on the axes.
struct SweepPoint {
    std::size_t view_index = 0;  ///< into ExperimentPlan::views
    std::size_t cell_index = 0;  ///< into that view's cells
    ParameterValues at;          ///< value on each axis that applies, by the axis' id
};

/// Methods over the product of some axes.
struct SweepPlan {
    nlohmann::json definition;  ///< an experiment's; null for a sweep of the command line
    std::string title;
    std::vector<std::string> axes;
    std::vector<SweepPoint> points;
    std::optional<double> budget_ms;  ///< limit for the AO pass with its filter
    std::vector<std::string> notes;   ///< axes and presets left out, with the reason
};

/// One change of a cell that advice measures.
struct StepPlan {
    std::string id;    ///< a row of advice_steps()
    std::string what;  ///< what is changed: "slices 3 to 6"
    std::optional<std::size_t>
        cell_index;  ///< into the view's cells; empty where the cell's own analysis tells
};

/// The steps from one cell, and those that it does not have.
struct AdvicePlan {
    std::size_t view_index = 0;  ///< into ExperimentPlan::views
    std::size_t cell_index = 0;  ///< into that view's cells
    std::vector<StepPlan> steps;
    std::vector<SkippedStep> skipped;
};

/// The step from a table's row to its method's preset `tuned` (see add_tuned_rows()).
struct TunedRowPlan {
    AdvicePlan step;
    nlohmann::json tuning;  ///< see TunedRowRecord
};

/// A published table to be rebuilt: its definition, and for each row the index of its cell.
struct TablePlan {
    nlohmann::json definition;
    std::size_t view_index = 0;             ///< index into ExperimentPlan::views
    std::vector<std::size_t> cell_indices;  ///< indices into that view's cells
    std::vector<TunedRowPlan> tuned;        ///< one for each row; empty in a first answer
};

/// Everything that one run will measure.
struct ExperimentPlan {
    std::vector<ViewPlan> views;
    std::vector<TablePlan> tables;
    std::vector<SweepPlan> sweeps;
    std::vector<AdvicePlan> advice;
    std::vector<std::string> claim_ids;  ///< claims to be judged by this run
    double claim_scale = 1;              ///< scale of the claims' views
    std::uint64_t seed = 1;
    std::filesystem::path methods_dir;                ///< folder of the user's own methods; empty: none
    std::vector<std::filesystem::path> preset_files;  ///< presets beside the descriptors', see add_presets()
    std::vector<OutsideMethod> outside;               ///< methods of other programs that cells name
    std::filesystem::path truth_cache;  ///< folder for truths and measurements; empty: none are kept
    bool keep_gbuffer = true;           ///< write the G-buffer beside the results
    /// Only the first answer is measured: goals are without ScoreGoal::every_metric, nothing is timed, and no
    /// advice is given.
    /// The whole plan goes on from its artifacts.
    bool first_answer = false;
    std::string command;                      ///< the command that runs it again
    std::shared_ptr<const Results> baseline;  ///< an earlier run to compare with; null: none
    std::vector<std::string> warnings;        ///< shown with the results
};

/// Whether a ScoreGoal decides the rays of some view.
bool has_score_goal(const ExperimentPlan& plan);
/// The plan that gives the first answer of `plan` (see ExperimentPlan::first_answer).
ExperimentPlan first_answer_of(ExperimentPlan plan);

/// The index of the plan's view of the same picture, added when there is none; it gets the finer of both
/// truths.
std::size_t shared_view(ExperimentPlan& plan, ViewPlan view);
/// The index of the same cell, added when there is none; it leaves the files of both.
std::size_t shared_cell(ViewPlan& view, CellPlan cell);

/// The cells of a method in a score without options: one for each preset that its descriptor names for
/// scores, in its modes. Throws file_error where these do not exist.
std::vector<CellPlan> scored_cells(const MethodDescriptor& method);

/// An experiment of a publication, or one of ours: one file of reports/.
struct ExperimentDefinition {
    enum class Kind { table, ranking, sweep };
    Kind kind = Kind::table;
    std::string id;
    std::string title;
    std::string source;  ///< author, title, year; empty for a ranking
    std::filesystem::path file;
};
/// The experiments of reports/*.json, by id.
std::vector<ExperimentDefinition> list_experiments();

/// Merges the definitions of these experiments into one plan: a view that several tables show is traced once,
/// a cell that several rows name is run once. A ranking adds methods to a scene's views, as `score` draws
/// them. Pictures are made `scale` times as wide and high as the definitions say. A sweep also measures what
/// the claims that it lists ask for, in pictures of their own size. In both, methods keep their own lengths,
/// as published. Throws usage_error for an unknown id (listing the known ones), file_error for a bad
/// definition.
ExperimentPlan plan_experiments(const std::vector<std::string>& ids, double scale = 1);

}  // namespace aoscore
