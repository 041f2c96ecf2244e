#include "cli/command.h"
#include "cli/method_options.h"
#include "cli/number_range.h"
#include "cli/shared_options.h"
#include "core/known_names.h"
#include "core/output.h"
#include "metrics/metric.h"
#include "page/tuning_page.h"
#include "results/results_folder.h"
#include "tuning/preset_files.h"
#include "tuning/tuning_definition.h"
#include "tuning/tuning_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <utility>

namespace aoscore {
namespace {

struct TuneOptions {
    std::vector<std::string> scenes, methods, parameters;
    std::vector<double> most_fetches, most_ms;
    std::string definition;
    std::filesystem::path scenes_dir;
    bool install = false;
    ViewChoice view;
    MethodOptions method_options;
    ImageSize size{640, 360};
    std::vector<double> radii;
    TuningPlan plan;
    std::filesystem::path out;
};

/// Every limit of fetches with every limit of milliseconds; one without limits where there are none.
std::vector<Budget> budgets_of(const TuneOptions& options) {
    std::vector<std::optional<double>> fetches(options.most_fetches.begin(), options.most_fetches.end());
    std::vector<std::optional<double>> ms(options.most_ms.begin(), options.most_ms.end());
    if (fetches.empty()) fetches.emplace_back();
    if (ms.empty()) ms.emplace_back();
    std::vector<Budget> budgets;
    for (const auto& most_fetches : fetches) {
        for (const auto& most_ms : ms) budgets.push_back({most_fetches, most_ms});
    }
    return budgets;
}

/// What the options say of scenes and methods.
void read_options(const TuneOptions& options, TuningPlan& plan) {
    if (options.scenes.empty() || options.methods.empty())
        throw usage_error("nothing says what to tune", "tune", "SCENE… --methods M, or --definition");
    if (options.scenes.size() > 1 && (options.view.load.camera || !options.view.load.view_file.empty()))
        throw usage_error("several scenes", "--views, --eye", "one scene: a camera is a place in it");
    plan.width = options.size.width;
    plan.height = options.size.height;
    plan.radius_m = one_finite_radius(options.radii, "settings are tuned");
    for (const std::string& scene : options.scenes)
        plan.scenes.push_back({scene, options.view.load, planned_views(options.view)});
    plan.budgets = budgets_of(options);
    std::vector<std::string> warnings;
    const Registry registry = load_registry(plan.methods_dir, options.methods, warnings);
    std::vector<MethodDescriptor> methods;
    for (const std::string& id : options.methods) methods.push_back(find_method(registry.methods, id));
    for (CellPlan& cell : plan_cells(methods, registry.filters, options.method_options, warnings))
        plan.methods.push_back({std::move(cell), options.parameters});
}

/// The name of the folder of results where the user names none.
std::string folder_name(const TuningPlan& plan) {
    if (!plan.definition.empty()) return "tune-" + plan.definition;
    std::vector<std::string> stems;
    for (const TuningPlan::OnScene& on : plan.scenes)
        stems.push_back(std::filesystem::path(on.scene).stem().string());
    return fmt::format("tune-{}", fmt::join(stems, "-"));
}

ExitCode run(const TuneOptions& options, const GlobalOptions& global) {
    TuningPlan plan = options.plan;
    plan.seed = global.seed;
    plan.command = global.command_line;
    if (options.definition.empty())
        read_options(options, plan);
    else
        read_tuning_definition(tuning_definition_file(options.definition), options.scenes_dir,
                               options.methods, plan);
    const std::filesystem::path folder = results_folder(options.out, folder_name(plan));
    const TuningResults results = tune(plan);
    write_tuning(results, plan, folder);
    print_tuning(results, plan);
    if (options.install) {
        for (const std::filesystem::path& file : install_presets(results, plan)) print_path(file);
    }
    print_path(folder / "tune.json");
    print_path(write_tuning_page(folder));
    return ExitCode::ok;
}

/// A definition says all that decides the result: of the other options only `methods` may be given too, since
/// no method's result depends on another's.
void add_definition_options(CLI::App& app, const CLI::Option* methods, TuneOptions& options) {
    std::vector<CLI::Option*> others;
    for (CLI::Option* option : app.get_options()) {
        if (option != app.get_help_ptr() && option != methods) others.push_back(option);
    }
    CLI::Option* definition = app.add_option(
        "--definition", options.definition,
        "A tuning that is written down: the name of a file in reports/tunings/, or the path of "
        "one; it says scenes, views, methods and effort, and --methods tunes some of its methods alone");
    for (CLI::Option* option : others) definition->excludes(option);
    app.add_option("--scenes-dir", options.scenes_dir,
                   "Folder of the definition's scenes that the program does not generate [this folder]")
        ->needs(definition)
        ->check(CLI::ExistingDirectory);
    app.add_flag("--install", options.install,
                 "Also write the definition's presets into the folders of the program's own methods, as "
                 "tuned.json, in place of those that are there; prints the files' paths")
        ->needs(definition);
}

}  // namespace

CommandEntry add_tune_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "tune",
        "Find the parameters of methods that come closest to the truth, and what they are worth on "
        "views that they were not tuned on; prints the paths of tune.json and its page");
    const auto options = std::make_shared<TuneOptions>();
    app->add_option("scene", options->scenes, "Built-in scenes (see list scenes), or files of scenes");
    add_view_options(*app, options->view);
    const CLI::Option* methods =
        app->add_option("--methods", options->methods, "Methods to tune (see list methods)")
            ->delimiter(',')
            ->allow_extra_args(false);
    app->add_option("--parameters", options->parameters,
                    "Parameters to tune [real numbers that affect visibility; with a budget integers too]")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--metric", options->plan.metric,
                    "The metric that decides; one without a best value is refused")
        ->capture_default_str()
        ->check(one_of(ids_of(metrics())));
    app->add_option("--max-fetches", options->most_fetches,
                    "Texture fetches a pixel that settings may cost; several are tuned one by one [any]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_above_zero());
    app->add_option("--budget-ms", options->most_ms,
                    "Milliseconds that the AO pass and its filter may take on this machine, "
                    "at this size on the first view; beside --max-fetches both are kept [any]")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_above_zero());
    app->add_option("--evaluations", options->plan.effort.global, "Settings that the global search tries")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    app->add_option("--refinements", options->plan.effort.local, "Settings that the local search tries")
        ->capture_default_str()
        ->check(CLI::Range(0, 100000));
    app->add_flag("--in-sample", options->plan.in_sample,
                  "Tune on a single view: nobody knows then how the settings do on others");
    add_method_options(*app, options->method_options);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    app->add_option("--samples", options->plan.samples, "Rays a pixel of the truth, an even number")
        ->capture_default_str()
        ->check(even_count());
    app->add_option("--methods-dir", options->plan.methods_dir, "A folder of methods of your own");
    add_definition_options(*app, methods, *options);
    add_cache_option(*app, options->plan.truth_cache);
    app->add_option(
        "--out", options->out,
        "Folder of tune.json, its page and the presets METHOD.tuned.json [reports/out/tune-SCENE]");
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
