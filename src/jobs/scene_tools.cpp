#include "jobs/scene_tools.h"

namespace aoscore {

void SceneTools::choose(const Scene& scene) {
    if (scene_ == &scene) return;
    scene_ = &scene;
    uploaded_ = nullptr;
    reference_.reset();
}

const ReferenceScene& SceneTools::reference() {
    if (!reference_) reference_.emplace(ReferenceScene::built_when_needed(*scene_));
    return *reference_;
}

ScreenRenderer& SceneTools::ready_renderer() {
    if (uploaded_ != scene_) renderer_.set_scene(*scene_);
    uploaded_ = scene_;
    return renderer_;
}

}  // namespace aoscore
