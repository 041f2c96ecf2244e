#include "cli/command.h"
#include "cli/number_range.h"
#include "cli/shared_options.h"
#include "core/output.h"
#include "results/results_folder.h"
#include "training/training_export.h"

#include <cmath>
#include <memory>

namespace aoscore {
namespace {

struct TrainingOptions {
    ImageSize size{640, 360};
    std::vector<double> radii;
    TrainingPlan plan;
    std::filesystem::path out;
};

ExitCode run(const TrainingOptions& options, const GlobalOptions& global) {
    TrainingPlan plan = options.plan;
    plan.seed = global.seed;
    plan.command = global.command_line;
    plan.width = options.size.width;
    plan.height = options.size.height;
    plan.radius_m = one_finite_radius(options.radii, "truths are traced");
    print_path(export_training(plan, results_folder(options.out, "training")));
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_export_training_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand("export-training",
                                           "Write G-buffers and truths of many views, split by scene, to "
                                           "learn from; prints the manifest's path");
    const auto options = std::make_shared<TrainingOptions>();
    app->add_option("scene", options->plan.scenes, "Built-in scenes (see list scenes), or files of scenes")
        ->required();
    add_frame_options(*app, options->plan.load);
    app->add_option("--views", options->plan.views, "Views of each scene")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    app->add_option("--height", options->plan.height_m,
                    "Eye level above the floor of rooms, metres [a third of the room]")
        ->check(number_above_zero());
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    app->add_option("--samples", options->plan.samples, "Rays a pixel of the truth")
        ->capture_default_str()
        ->check(CLI::Range(1, kMostSamples));
    add_cache_option(*app, options->plan.truth_cache);
    app->add_option("--out", options->out,
                    "Folder of the EXR files and manifest.json [reports/out/training]");
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
