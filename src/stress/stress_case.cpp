#include "stress/stress_case.h"

#include "scene/scene_bounds.h"
#include "scene/scene_digest.h"

namespace aoscore {

StressCase base_stress_case(int size) {
    StressCase base;
    base.scene = load_scene("yard");
    base.camera = base.scene.views.front().camera;
    base.width = base.height = size;
    return base;
}

void finish_stress_case(StressCase& stress) {
    Scene& scene = stress.scene;
    scene.views.resize(1);
    scene.views.front().camera = stress.camera;
    // A scene without triangles has no bounds of its own, and keeps the earlier ones.
    if (!scene.instances.empty()) {
        measure_scene(scene, scene.id);
        move_origin(scene, suitable_origin(scene.bounds));
    } else {
        scene.triangle_count = 0;
    }
    stress.camera = scene.views.front().camera;
    scene.digest = scene_digest(scene);
}

}  // namespace aoscore
