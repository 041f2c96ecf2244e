#include "cli/command.h"
#include "cli/method_options.h"
#include "cli/number_range.h"
#include "cli/run_and_page.h"
#include "cli/shared_options.h"
#include "core/files.h"
#include "core/output.h"
#include "plan/resolved_cell.h"
#include "plan/view_description.h"
#include "results/results_folder.h"
#include "worst/worst_views.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {
namespace {

struct WorstOptions {
    std::string scene;
    LoadOptions load;
    std::vector<std::string> methods, between;
    MethodOptions method_options;
    ImageSize size{640, 360};
    std::vector<double> radii;
    WorstPlan plan;
    std::filesystem::path out;
    OutcomeOptions outcome;
};

/// The first cell of each method.
std::vector<CellPlan> cells_of(const WorstOptions& options, const std::vector<std::string>& ids,
                               std::vector<std::string>& warnings) {
    const Registry registry = load_registry(options.plan.methods_dir, ids, warnings);
    std::vector<CellPlan> first;
    for (const std::string& id : ids) {
        std::vector<MethodDescriptor> one{find_method(registry.methods, id)};
        first.push_back(plan_cells(one, registry.filters, options.method_options, warnings).front());
    }
    return first;
}

void print(const WorstPlan& plan, const WorstViews& found) {
    print_result("{} of {} cameras {} can be judged at R {:g} m; {} of them, in the median {:.4f}\n",
                 found.judged, found.tried, found.inside ? "in rooms" : "outside", found.radius_m,
                 plan.rival ? fmt::format("{} is behind {} on {}", plan.method.method, plan.rival->method,
                                          found.rival_won)
                            : fmt::format("{} errs on each", plan.method.method),
                 found.median);
    for (const FoundView& one : found.views) {
        print_result("{:<9} {:.4f} (a small picture: {:.4f})\n", one.view.id, one.confirmed, one.coarse);
    }
    print_result("The worst found is not the worst there is: cameras between these may be worse.\n");
}

/// The score of the methods on the views that were found.
ExperimentPlan score_of(const WorstOptions& options, std::vector<CellPlan> cells,
                        const std::filesystem::path& views, const WorstViews& found) {
    ExperimentPlan plan;
    plan.seed = options.plan.seed;
    plan.methods_dir = options.plan.methods_dir;
    plan.command = options.plan.command;
    plan.truth_cache = options.plan.truth_cache;
    ViewPlan view;
    view.scene = options.scene;
    view.load = options.load;
    view.load.view_file = views;
    view.width = options.size.width;
    view.height = options.size.height;
    view.score_goal = ScoreGoal();
    view.cells = std::move(cells);
    for (const FoundView& one : found.views) {
        view.view = one.view.id;
        shared_view(plan, view);
    }
    return plan;
}

/// Refuses all but methods alone, or a pair of two methods alone.
void require_one_judgement(const WorstOptions& options) {
    const std::vector<std::string>& pair = options.between;
    if (options.methods.empty() && pair.empty())
        throw usage_error("nothing says what to judge by", "worst", "either --methods or --between");
    if (!options.methods.empty() && !pair.empty())
        throw usage_error("both say what to judge by", "--methods, --between", "one of them");
    if (!pair.empty() && pair.size() != 2)
        throw usage_error("names no pair", "--between", "two methods: a,b");
    if (!pair.empty() && pair[0] == pair[1])
        throw usage_error(pair[0] + " cannot be behind itself", "--between", "two methods: a,b");
    const OutcomeOptions& outcome = options.outcome;
    const bool concludes = !outcome.fail.empty() || !outcome.warn.empty() || !outcome.exports.empty();
    if (concludes && options.methods.size() > 1)
        throw usage_error("limits and exports are of the views of one method", "--methods", "one method");
}

ExitCode run(const WorstOptions& options, const GlobalOptions& global) {
    require_one_judgement(options);
    // A fault in a limit or in an export's path is found before the search, which takes long.
    { const Outcome checked(options.outcome); }
    WorstOptions chosen = options;
    WorstPlan& plan = chosen.plan;
    plan.seed = global.seed;
    plan.command = global.command_line;
    plan.width = options.size.width;
    plan.height = options.size.height;
    plan.radius_m = one_finite_radius(options.radii, "views are judged");
    std::vector<std::string> warnings;
    const bool pair = !options.between.empty();
    const std::vector<CellPlan> cells = cells_of(chosen, pair ? options.between : options.methods, warnings);
    const std::string stem = std::filesystem::path(options.scene).stem().string();
    const std::filesystem::path folder = results_folder(options.out, "worst-" + stem);
    const Scene scene = load_with_warnings(options.scene, options.load);
    for (std::size_t i = 0; i < (pair ? 1 : cells.size()); ++i) {
        plan.method = cells[i];
        if (pair) plan.rival = cells[1];
        const WorstViews found = find_worst_views(plan, scene);
        const std::filesystem::path place = cells.size() > 1 && !pair ? folder / cells[i].method : folder;
        const std::filesystem::path views = place / (stem + ".views.json");
        std::vector<View> worst;
        for (const FoundView& one : found.views) worst.push_back(one.view);
        write_atomically(views, view_file_text(scene, worst) + "\n");
        print(plan, found);
        print_path(views);
        const ExitCode code =
            run_and_page(score_of(chosen, pair ? cells : std::vector{cells[i]}, views, found), place,
                         options.outcome, global);
        if (code != ExitCode::ok) return code;
    }
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_worst_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand("worst",
                                           "Search a scene for the views on which a method errs most; prints "
                                           "the paths of a view file and a page");
    const auto options = std::make_shared<WorstOptions>();
    app->add_option("scene", options->scene, "Built-in id (see list scenes) or a scene's file")->required();
    add_frame_options(*app, options->load);
    app->add_option("--methods", options->methods,
                    "Methods to search for, one after the other (see list methods)")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--between", options->between,
                    "a,b: the views on which method a is farthest behind method b")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->add_option("--cameras", options->plan.cameras, "Cameras to try")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    app->add_option("--count", options->plan.views, "Views to find")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    app->add_option("--height", options->plan.height_m,
                    "Eye level above the floor of rooms, metres [a third of the room]")
        ->check(number_above_zero());
    app->add_option("--samples", options->plan.samples,
                    "Rays a pixel of the truths that confirm, an even number")
        ->capture_default_str()
        ->check(even_count());
    add_method_options(*app, options->method_options);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    app->add_option("--methods-dir", options->plan.methods_dir, "A folder of methods of your own");
    add_cache_option(*app, options->plan.truth_cache);
    app->add_option("--out", options->out, "Folder of view file, page and results [reports/out/worst-SCENE]");
    add_outcome_options(*app, options->outcome);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
