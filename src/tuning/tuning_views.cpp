#include "tuning/tuning_views.h"

#include "core/error.h"
#include "store/code_digest.h"
#include "store/truth/truth_cache.h"

namespace aoscore {

std::unique_ptr<TuningView> ready_view(const TuningViewPlan& plan, const ReferenceScene& reference,
                                       ScreenRenderer& renderer, const std::set<std::string>& inputs,
                                       const std::filesystem::path& truth_cache, const std::string& command) {
    const Scene& scene = *plan.scene;
    auto view = std::make_unique<TuningView>();
    view->key = scene.id + "/" + plan.view.id;
    view->scene = scene.id;
    view->orthographic = plan.view.camera.projection == Camera::Projection::orthographic;
    view->radius = ranking_radius(plan.radius_m, plan.view, scene);
    const CameraFrame frame(plan.view.camera, plan.width, plan.height);
    TruthRequest request{.scene_digest = scene.digest,
                         .camera = plan.view.camera,
                         .width = plan.width,
                         .height = plan.height,
                         .queries = {{Falloff::binary, view->radius.metres, 0}},
                         .settings = {},
                         .build = {}};
    request.settings.samples = plan.samples;
    request.settings.halves = true;
    view->truth = trace_truth(truth_cache, reference, request, {scene_name(scene), plan.view.id, command},
                              "truth " + view->key)
                      .truth;
    renderer.draw_gbuffer(frame, inputs);
    view->gbuffer = renderer.keep_gbuffer();
    view->ground = find_ground(frame, view->truth, renderer.read_gbuffer(), scene.bounds);
    try {
        require_comparable(view->ground);
    } catch (const Error& e) {
        throw Error(e.exit_code(), e.what(), view->key);
    }
    view->made_of = KeyBuilder("tuning", "score")
                        .text(request.picture_key())
                        .text(request.wanted_key())
                        .text(renderer.renderer())
                        .text(code_digest("truth"))
                        .text(code_digest("image"))
                        .text(code_digest("contract"))
                        .key();
    return view;
}

}  // namespace aoscore
