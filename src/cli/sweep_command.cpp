#include "cli/command.h"
#include "cli/method_options.h"
#include "cli/number_range.h"
#include "cli/run_and_page.h"
#include "cli/shared_options.h"
#include "plan/sweep.h"
#include "results/results_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>

namespace aoscore {
namespace {

struct SweepOptions {
    std::vector<std::string> scenes;
    ViewChoice view;
    std::vector<std::string> methods;
    std::vector<std::string> axes;
    MethodOptions method_options;
    ImageSize size;
    std::vector<double> radii;
    TruthEffort effort;
    std::optional<double> budget_ms;
    bool keep_images = false;
    std::filesystem::path methods_dir;
    std::filesystem::path truth_cache;
    std::filesystem::path out;
    OutcomeOptions outcome;
};

SweepRequest request_of(const SweepOptions& options, const Registry& registry) {
    SweepRequest request;
    request.methods = options.methods;
    if (options.methods.empty() || options.methods == std::vector<std::string>{"all"}) {
        request.methods.clear();
        for (const MethodDescriptor& method : registry.methods) request.methods.push_back(method.id);
    }
    if (!options.method_options.preset.empty()) request.base.preset = options.method_options.preset;
    if (!options.method_options.filter.empty()) request.base.filter = options.method_options.filter;
    request.base.modes = options.method_options.modes;
    request.base.own_truth = false;
    request.base.keep_image = options.keep_images;
    for (const std::string& text : options.method_options.assignments)
        request.set.push_back(parse_assignment(text));
    for (const std::string& text : options.axes) {
        SweepAxis axis = parse_axis(text);
        for (const SweepAxis& other : request.axes) {
            if (other.id == axis.id) throw usage_error(axis.id + " is varied twice", "--vary " + text);
        }
        request.axes.push_back(std::move(axis));
    }
    return request;
}

ExitCode run(const SweepOptions& options, const GlobalOptions& global) {
    ExperimentPlan plan;
    plan.seed = global.seed;
    plan.truth_cache = options.truth_cache;
    plan.methods_dir = options.methods_dir;
    plan.command = global.command_line;
    plan.keep_gbuffer = options.keep_images;
    ViewPlan view;
    view.width = options.size.width;
    view.height = options.size.height;
    view.samples = options.effort.least_samples();
    view.max_error = options.effort.max_error;
    view.own_parameters = options.method_options.own_parameters;
    view.radius_m = one_finite_radius(options.radii, "a sweep is ranked");
    view.extras = {};  // extras describe one picture in detail, which curves cannot show
    view.timing_goal = TimingGoal();
    view.lit = true;
    const Registry registry = load_registry(options.methods_dir, options.methods, plan.warnings);
    const SweepRequest request = request_of(options, registry);
    SweepPlan sweep;
    sweep.title = fmt::format("Sweep of {}", fmt::join(options.scenes, ", "));
    sweep.budget_ms = options.budget_ms;
    if (options.scenes.size() > 1 && (options.view.load.camera || !options.view.load.view_file.empty()))
        throw usage_error("several scenes", "--views, --eye", "one scene: a camera is a place in it");
    view.load = options.view.load;
    for (const std::string& scene : options.scenes) {
        view.scene = scene;
        for (const std::string& id : planned_views(options.view)) {
            view.view = id;
            add_sweep(plan, view, request, sweep, registry);
        }
    }
    for (const std::string& note : sweep.notes) log_info(note);
    plan.sweeps.push_back(std::move(sweep));
    std::vector<std::string> stems;
    for (const std::string& scene : options.scenes)
        stems.push_back(std::filesystem::path(scene).stem().string());
    const std::filesystem::path folder =
        results_folder(options.out, fmt::format("sweep-{}", fmt::join(stems, "-")));
    return run_and_page(std::move(plan), folder, options.outcome, global);
}

}  // namespace

CommandEntry add_sweep_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "sweep", "Run time against error over parameters of methods; prints the page's path");
    const auto options = std::make_shared<SweepOptions>();
    app->add_option("scene", options->scenes,
                    "Built-in scenes (see list scenes), or files of scenes; several have one front together")
        ->required();
    add_view_options(*app, options->view);
    app->add_option("--methods", options->methods, "Methods to sweep (see list methods) [all]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--vary", options->axes,
                    "PARAM=v1,v2,...: a parameter, filter.PARAM, preset, filter, size, resolution, border, "
                    "normals or precision; several make their product")
        ->allow_extra_args(false)
        ->required();
    app->add_option("--budget-ms", options->budget_ms,
                    "What AO and filter may cost here; the page names the most accurate setting within it")
        ->check(number_above_zero());
    add_method_options(*app, options->method_options);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    add_truth_options(*app, options->effort);
    app->add_flag("--images", options->keep_images, "Keep every picture, and show them on the page");
    app->add_option("--methods-dir", options->methods_dir, "A folder of methods of your own");
    add_cache_option(*app, options->truth_cache);
    app->add_option("--out", options->out,
                    "Folder of page, results.json and sweep.csv [reports/out/sweep-SCENE]");
    add_outcome_options(*app, options->outcome);
    add_job_options(*app, options->outcome.jobs);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
