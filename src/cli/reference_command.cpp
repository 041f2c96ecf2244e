#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/files.h"
#include "experiment/experiment.h"
#include "experiment/image_output.h"
#include "reference/truth.h"

#include <fmt/format.h>

#include <memory>

namespace aoscore {
namespace {

struct Options {
    SceneChoice choice;
    ImageSize size;
    std::vector<double> radii;
    TruthEffort effort;
    bool shading_normals = false;
    TruthExtras extras;
    std::filesystem::path out;
};

ExitCode run(const Options& options, const GlobalOptions& global) {
    const Scene scene = load_with_warnings(options.choice.scene);
    const View& view = one_view(scene, options.choice.view);
    const CameraFrame frame(view.camera, options.size.width, options.size.height);
    std::vector<TruthQuery> queries;
    for (const double radius : options.radii) queries.push_back({Falloff::binary, radius, 0});
    if (queries.empty()) {
        std::vector<std::string> warnings;
        queries.push_back({Falloff::binary, ranking_radius({}, view, scene, warnings), 0});
        for (const std::string& warning : warnings) log_warning(warning);
    }
    TruthSettings settings;
    settings.samples = options.effort.samples;
    settings.max_error = options.effort.max_error;
    settings.seed = global.seed;
    settings.shading_normals = options.shading_normals;
    settings.extras = options.extras;
    const Truth truth =
        ReferenceScene(scene).trace(frame, queries, settings, fmt::format("truth {}/{}", scene.id, view.id));
    write_truth(options.out, truth, truth.hits.surface,
                {{"aoscore:scene", scene.id},
                 {"aoscore:scene_digest", scene.digest},
                 {"aoscore:view", view.id},
                 {"aoscore:seed", fmt::format("{}", global.seed)},
                 {"aoscore:version", std::string(version())},
                 {"comments", global.command_line}});
    fmt::print("{}\n", options.out.string());
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_reference_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "reference",
        "Ray-trace the truth of one view into an EXR: Y is the visibility at the first radius, V0.Y, "
        "V1.Y, ... at each of them, SE.Y the standard error, mask.Y 0 where there is no surface");
    const auto options = std::make_shared<Options>();
    add_scene_options(*app, options->choice);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    add_truth_options(*app, options->effort);
    app->add_flag("--shading-normals", options->shading_normals, "Hemisphere about the smooth normal");
    add_extras_options(*app, options->extras);
    app->add_option("--out", options->out, "EXR file to write")->required();
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
