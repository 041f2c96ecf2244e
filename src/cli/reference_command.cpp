#include "cli/command.h"
#include "cli/shared_options.h"
#include "core/log.h"
#include "core/output.h"
#include "jobs/image_output.h"
#include "jobs/truth_provenance.h"
#include "plan/ranking_radius.h"
#include "store/truth/truth_cache.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

namespace aoscore {
namespace {

struct ReferenceOptions {
    SceneChoice choice;
    ImageSize size;
    std::vector<double> radii;
    TruthEffort effort;
    bool halves = false;
    bool shading_normals = false;
    TruthExtras extras;
    std::filesystem::path out;
    std::filesystem::path truth_cache;
};

ExitCode run(const ReferenceOptions& options, const GlobalOptions& global) {
    const Scene scene = load_with_warnings(options.choice.scene, options.choice.view.load);
    const View view = one_view(scene, options.choice.view, options.size, options.truth_cache);
    std::vector<TruthQuery> queries;
    for (const double radius : options.radii) queries.push_back({Falloff::binary, radius, 0});
    if (queries.empty()) {
        const RankingRadius radius = ranking_radius({}, view, scene);
        queries.push_back({Falloff::binary, radius.metres, 0});
        if (radius.automatic) log_warning(radius_warning(radius, view));
    }
    TruthSettings settings;
    settings.samples = options.effort.least_samples();
    settings.max_error = options.effort.max_error;
    settings.mean_error = options.effort.mean_error;
    settings.halves = options.halves;
    settings.seed = global.seed;
    settings.shading_normals = options.shading_normals;
    settings.extras = options.extras;
    const ReferenceScene reference = ReferenceScene::built_when_needed(scene);
    const TruthRequest request{scene.digest, view.camera, options.size.width, options.size.height,
                               queries,      settings,    reference.build()};
    const CachedTruth traced = trace_truth(options.truth_cache, reference, request,
                                           {scene_name(scene), view.id, global.command_line},
                                           fmt::format("truth {}/{}", scene.id, view.id));
    std::map<std::string, std::string> header = truth_provenance(
        scene, traced, reference_command(scene, view, traced.made_for, options.out.string()));
    header["aoscore:view"] = view.id;
    write_truth(options.out, traced.truth, traced.truth.hits.surface, header);
    print_path(options.out);
    return ExitCode::ok;
}

}  // namespace

CommandEntry add_reference_command(CLI::App& program, const GlobalOptions& global) {
    CLI::App* app = program.add_subcommand(
        "reference",
        "Ray-trace the truth of one view into an EXR: Y is the visibility at the first radius, V0.Y, "
        "V1.Y, ... at each of them, SE.Y the standard error, mask.Y 0 where there is no surface");
    const auto options = std::make_shared<ReferenceOptions>();
    add_scene_options(*app, options->choice);
    add_size_option(*app, options->size);
    add_radii_option(*app, options->radii);
    add_truth_options(*app, options->effort);
    app->add_option(
           "--mean-error", options->effort.mean_error,
           "Trace with as many rays in every pixel as bring the mean standard error over the picture to "
           "this; says first how many that are")
        ->check(error_of_truth())
        ->excludes("--error");
    app->add_flag(
           "--halves", options->halves,
           "Trace two independent halves of the rays, as scores with --score-error do, and write their mean")
        ->excludes("--error")
        ->excludes("--mean-error");
    app->add_flag("--shading-normals", options->shading_normals, "Hemisphere about the smooth normal");
    add_extras_options(*app, options->extras);
    add_cache_option(*app, options->truth_cache);
    add_exr_option(*app, options->out);
    return {app, [options, &global] { return run(*options, global); }};
}

}  // namespace aoscore
