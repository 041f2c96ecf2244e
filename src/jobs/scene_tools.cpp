#include "jobs/scene_tools.h"

namespace aoscore {

SceneTools::SceneTools() {
    renderer_.set_ray_layers([this](const CameraFrame& frame, const DepthLayers& layers) {
        return reference().ray_layers(
            frame, {.samples = layers.samples, .reach_m = layers.reach_m, .seed = layers.seed});
    });
}

void SceneTools::choose(const Scene& scene) {
    // Another scene may have the address of an earlier one.
    if (scene_ == &scene && digest_ == scene.digest) return;
    scene_ = &scene;
    digest_ = scene.digest;
    uploaded_ = nullptr;
    reference_.reset();
}

const ReferenceScene& SceneTools::reference() {
    if (!reference_) reference_.emplace(ReferenceScene::built_when_needed(*scene_));
    return *reference_;
}

ScreenRenderer& SceneTools::ready_renderer() {
    std::optional<Capture> drawn;
    if (renderer_.lost()) {
        drawn = renderer_.renew();
        uploaded_ = nullptr;
    }
    // A recorded frame's scene has nothing to draw.
    if (uploaded_ != scene_ && !scene_->meshes.empty()) renderer_.set_scene(*scene_);
    uploaded_ = scene_;
    if (drawn) renderer_.draw_gbuffer(*drawn);
    return renderer_;
}

}  // namespace aoscore
