#include "cli/command.h"
#include "cli/environment_options.h"
#include "cli/frame_options.h"
#include "cli/method_options.h"
#include "cli/run_and_page.h"
#include "cli/shared_options.h"
#include "core/error.h"
#include "core/known_names.h"
#include "jobs/truth_signals.h"
#include "plan/advice_steps.h"
#include "plan/plan.h"
#include "plan/recorded_cells.h"
#include "results/results_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace aoscore {
namespace {

struct ScoreOptions {
    SceneChoice choice;
    FrameOptions frame;
    std::vector<std::string> methods;
    MethodOptions method_options;
    EnvironmentOptions environment;
    ImageSize size;
    std::vector<double> radii;
    TruthEffort effort;
    std::filesystem::path methods_dir;
    std::vector<std::string> contestants;
    bool advise = false;
    std::filesystem::path out;
    OutcomeOptions outcome;
    std::filesystem::path truth_cache;
};

std::vector<MethodDescriptor> chosen_methods(const ScoreOptions& options,
                                             std::vector<std::string>& warnings) {
    std::vector<MethodDescriptor> known = load_asked_methods(options.methods_dir, options.methods, warnings);
    if (options.methods.empty() || options.methods == std::vector<std::string>{"all"}) return known;
    std::vector<MethodDescriptor> chosen;
    for (const std::string& id : options.methods) chosen.push_back(find_method(known, id));
    return chosen;
}

/// Adds a cell for each preset of an outside method.
void add_outside(OutsideMethod outside, ExperimentPlan& plan, ViewPlan& view) {
    for (const auto& [preset, values] : outside.method.presets) {
        CellPlan cell;
        cell.method = outside.method.id;
        cell.preset = preset;
        cell.own_truth = false;
        view.cells.push_back(std::move(cell));
    }
    plan.outside.push_back(std::move(outside));
}

/// Adds the outside methods that the user named. No two contestants have one id.
void add_contestants(const ScoreOptions& options, ExperimentPlan& plan, ViewPlan& view) {
    std::vector<std::string> said;  // warnings given for the chosen methods
    std::vector<std::string> ids = ids_of(load_asked_methods(options.methods_dir, {}, said));
    for (const std::string& named : options.contestants) {
        const std::filesystem::path folder = outside_folder(named);
        OutsideMethod outside = load_outside_method(folder);
        if (std::ranges::find(ids, outside.method.id) != ids.end())
            throw file_error("is " + outside.method.id + ", as another contestant's",
                             (folder / "contestant.json").string() + ": id", "an id of its own");
        ids.push_back(outside.method.id);
        add_outside(std::move(outside), plan, view);
    }
}

/// Makes the view one of the frame, whose cells need no more than it holds.
void take_frame(const ScoreOptions& options, const std::vector<MethodDescriptor>& methods,
                ExperimentPlan& plan, ViewPlan& view) {
    view.recorded = read_frame_view(options.frame);
    view.scene = view.recorded->scene->id;
    view.width = view.recorded->width;
    view.height = view.recorded->height;
    view.radius_m = view.recorded->radius_m;
    view.score_goal.reset();
    view.extras = {};
    leave_out_cells(*view.recorded, methods, view.cells, plan.warnings);
    if (!options.frame.own.empty()) add_outside(own_contestant(options.frame), plan, view);
}

/// The methods and filters that the plan may name, with its presets.
Registry registry_for(const ExperimentPlan& plan) {
    std::vector<std::string> said;  // warnings given for the chosen methods
    Registry registry = load_registry(plan.methods_dir, {}, said);
    for (const std::filesystem::path& file : plan.preset_files) add_presets(registry.methods, file);
    return registry;
}

/// The view of the scene, without cells.
ViewPlan scene_view(const ScoreOptions& options) {
    ViewPlan view;
    view.scene = options.choice.scene;
    view.load = options.choice.view.load;
    view.width = options.size.width;
    view.height = options.size.height;
    view.samples = options.effort.least_samples();
    view.max_error = options.effort.max_error;
    view.own_parameters = options.method_options.own_parameters;
    view.score_goal = score_goal(options.effort);
    view.radius_m = one_finite_radius(options.radii, "a score is ranked");
    return view;
}

ExitCode run(ScoreOptions options, const GlobalOptions& global) {
    if (options.choice.scene.empty() && !options.frame.given())
        throw usage_error("nothing to score", "score", "SCENE, or --gbuffer with --truth");
    ExperimentPlan plan;
    plan.seed = global.seed;
    plan.methods_dir = options.methods_dir;
    plan.command = global.command_line;
    plan.truth_cache = options.truth_cache;
    ViewPlan view = scene_view(options);
    options.frame.truth.radius_m = view.radius_m;
    std::vector<MethodDescriptor> methods = chosen_methods(options, plan.warnings);
    plan.preset_files = options.method_options.preset_files();
    view.cells = plan_cells(methods, load_filters(), options.method_options, plan.warnings);
    view.extras |= extras_for(options.method_options.signals);
    if (options.frame.given() && options.environment.given())
        throw usage_error("a frame has no scene to trace light in", "--environment", "with SCENE");
    if (options.frame.given()) take_frame(options, methods, plan, view);
    if (!options.contestants.empty()) add_contestants(options, plan, view);
    light_view(options.environment, methods, view, plan.warnings);
    for (const std::string& id :
         options.frame.given() ? std::vector<std::string>{"frame"} : planned_views(options.choice.view)) {
        view.view = id;
        shared_view(plan, view);
    }
    if (options.advise) add_advice(plan, registry_for(plan));
    const std::string stem = std::filesystem::path(view.scene).stem().string();
    const std::filesystem::path folder = results_folder(options.out, "score-" + stem);
    return run_and_page(std::move(plan), folder, options.outcome, global);
}

}  // namespace

CommandEntry add_score_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app =
        program.add_subcommand("score", "Score methods on the views of a scene; prints the page's path");
    const auto options = std::make_shared<ScoreOptions>();
    add_scene_options(*app, options->choice);
    app->add_option("--methods", options->methods, "Methods to score (see list methods) [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    add_method_options(*app, options->method_options);
    add_signals_option(*app, options->method_options.signals);
    add_environment_options(*app, options->environment);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    add_score_truth_options(*app, options->effort);
    app->add_option("--methods-dir", options->methods_dir, "A folder of methods of your own");
    app->add_option("--contestant", options->contestants,
                    "A method of another program, ranked among the methods: a folder with contestant.json, "
                    "which has images of the views or a command that makes them, or an id (see list "
                    "contestants)")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_flag(
        "--advise", options->advise,
        "Also measure what the next step from each method would buy: more taps, exact normals, a guard "
        "band, … ; prints a table");
    add_cache_option(*app, options->truth_cache);
    app->add_option("--out", options->out, "Folder of page, results and images [reports/out/score-SCENE]");
    add_outcome_options(*app, options->outcome);
    add_job_options(*app, options->outcome.jobs);
    add_baseline_option(*app, options->outcome);
    add_recorded_options(*app, options->frame);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
