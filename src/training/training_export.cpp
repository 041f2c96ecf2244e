#include "training/training_export.h"

#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/log.h"
#include "framing/automatic_views.h"
#include "framing/spread_cameras.h"
#include "image/channels.h"
#include "jobs/image_output.h"
#include "jobs/truth_channels.h"
#include "jobs/truth_provenance.h"
#include "plan/ranking_radius.h"
#include "plan/view_description.h"
#include "results/view_piece.h"
#include "screen/screen.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// So many cameras are tried for each that is wanted, and so many at least.
constexpr std::size_t kTriedForEach = 6, kLeastTried = 100;

std::vector<View> chosen_views(const TrainingPlan& plan, const Scene& scene, double radius_m) {
    const Scout scout(scene);
    const MainPart main = main_part(scene);
    const SpreadCameras spread =
        spread_cameras({scout, main, radius_m, static_cast<double>(plan.width) / plan.height, scene.bounds},
                       std::max(kTriedForEach * plan.views, kLeastTried), plan.height_m);
    std::vector<View> views;
    for (const Candidate& candidate : distinct_cameras(spread, plan.views)) {
        View view = automatic_view_of(fmt::format("view_{:03}", views.size() + 1), candidate.camera);
        view.radius_m = radius_m;
        views.push_back(std::move(view));
    }
    if (views.empty()) throw no_camera_to_judge(spread, scene.id);
    if (views.size() < plan.views) {
        log_warning(
            fmt::format("{}: {} distinct views were found, not {}", scene.id, views.size(), plan.views));
    }
    return views;
}

void write_drawn(ScreenRenderer& renderer, const Scene& scene, const View& view, const CameraFrame& frame,
                 const TrainingPlan& plan, const fs::path& file) {
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const GBufferImages gbuffer = renderer.read_gbuffer();
    write_gbuffer(file, gbuffer, view_positions(gbuffer, frame),
                  gbuffer_attributes(scene, view.id, frame, renderer.renderer(), plan.command));
}

void write_traced(const ReferenceScene& reference, const Scene& scene, const View& view,
                  const TrainingPlan& plan, const fs::path& file) {
    TruthSettings settings;
    settings.samples = plan.samples;
    settings.seed = plan.seed;
    settings.extras.causes = true;
    const TruthRequest request{
        scene.digest, view.camera,      plan.width, plan.height, {{Falloff::binary, *view.radius_m, 0}},
        settings,     reference.build()};
    const CachedTruth traced =
        trace_truth(plan.truth_cache, reference, request, {scene_name(scene), view.id, plan.command},
                    fmt::format("truth {}/{}", scene.id, view.id));
    std::map<std::string, std::string> header = truth_provenance(scene, traced, plan.command);
    header["aoscore:view"] = view.id;
    write_truth(file, traced.truth, traced.truth.hits.surface, header);
}

/// The channels of both files with their meanings.
json channels_json() {
    json gbuffer = json::object(), truth = json::object();
    for (const Channel& channel : gbuffer_channels()) {
        for (const std::string_view name : channel.exr_names)
            gbuffer[std::string(name)] = std::string(channel.meaning);
    }
    for (const TruthChannel& channel : truth_channels()) {
        if (channel.gathered_by != nullptr && channel.gathered_by != &TruthExtras::causes) continue;
        for (const std::string& name : channel.exr_names) truth[name] = channel.meaning;
    }
    gbuffer[std::string(kMaskChannel)] = truth[std::string(kMaskChannel)] = "1 where there is a surface";
    return {{"gbuffer", std::move(gbuffer)}, {"truth", std::move(truth)}};
}

json exported_scene(const TrainingPlan& plan, const Scene& scene, const fs::path& folder) {
    const double radius_m = search_radius_m(plan.radius_m, scene);
    const ReferenceScene reference = ReferenceScene::built_when_needed(scene);
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    json items = json::array();
    for (const View& view : chosen_views(plan, scene, radius_m)) {
        throw_if_interrupted();
        const fs::path stem = fs::path(scene.id) / view.id;
        const fs::path drawn = stem.string() + ".gbuffer.exr", traced = stem.string() + ".truth.exr";
        const CameraFrame frame(view.camera, plan.width, plan.height);
        write_drawn(renderer, scene, view, frame, plan, folder / drawn);
        write_traced(reference, scene, view, plan, folder / traced);
        ViewRecord record = describe_view(scene, view, frame, scene.id + "/" + view.id);
        record.radius_m = radius_m;
        items.push_back(
            {{"view", view_piece(record)}, {"gbuffer", drawn.string()}, {"truth", traced.string()}});
    }
    return {{"scene", scene.id},
            {"scene_digest", scene.digest},
            {"radius_m", radius_m},
            {"items", std::move(items)}};
}

void require_different_names(const std::vector<Scene>& scenes) {
    std::set<std::string> ids;
    for (const Scene& scene : scenes) {
        if (!ids.insert(scene.id).second)
            throw usage_error("two scenes have one name", scene.id, "files with names of their own");
    }
}

}  // namespace

std::vector<std::string> splits_of(const std::vector<std::string>& digests) {
    std::vector<std::string> sorted = digests;
    std::ranges::sort(sorted);
    sorted.erase(std::ranges::unique(sorted).begin(), sorted.end());
    const std::size_t n = sorted.size();
    std::size_t held = static_cast<std::size_t>(std::lround(static_cast<double>(n) / 6));
    if (n > 1) held = std::max<std::size_t>(held, 1);
    const std::size_t validation = n > 2 ? held : 0;
    std::vector<std::string> splits;
    for (const std::string& digest : digests) {
        const auto place =
            static_cast<std::size_t>(std::ranges::lower_bound(sorted, digest) - sorted.begin());
        const bool is_test = n > 1 && place < held;
        splits.emplace_back(is_test ? "test" : place < held + validation && n > 1 ? "validation" : "train");
    }
    return splits;
}

fs::path export_training(const TrainingPlan& plan, const fs::path& folder) {
    std::vector<Scene> scenes;
    std::vector<std::string> digests;
    LoadOptions load = plan.load;
    load.albedo_textures = true;
    for (const std::string& name : plan.scenes) {
        scenes.push_back(load_scene(name, load));
        for (const std::string& warning : scenes.back().warnings) log_warning(warning);
        digests.push_back(scenes.back().digest);
    }
    require_different_names(scenes);
    const std::vector<std::string> splits = splits_of(digests);
    if (std::ranges::count(splits, "train") == static_cast<std::ptrdiff_t>(splits.size()))
        log_warning("one scene is all for training: another split of it would leak");
    json exported = json::array();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        json scene = exported_scene(plan, scenes[i], folder);
        scene["split"] = splits[i];
        exported.push_back(std::move(scene));
    }
    const json manifest = {{"schema_version", 1},          {"program_version", version()},
                           {"command", plan.command},      {"size", {plan.width, plan.height}},
                           {"rays_a_pixel", plan.samples}, {"channels", channels_json()},
                           {"scenes", std::move(exported)}};
    const fs::path path = folder / "manifest.json";
    write_atomically(path, manifest.dump(2) + "\n");
    return path;
}

}  // namespace aoscore
