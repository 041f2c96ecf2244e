#include "scene/builtin/arches.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace aoscore::builtin {

Scene generate_cathedral() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.66f, 0.64f, 0.6f));
    MeshBuilder floor;
    add_box(floor, {-20, -0.5, -8}, {20, 0, 8});
    scene.place(scene.mesh(floor, stone));
    MeshBuilder arch;
    add_arched_wall(arch, pointed_arch(2, 3, 10), 2.5, 6, 0.5);
    const int arches = scene.mesh(arch, stone);
    for (int i = -3; i <= 3; ++i) {
        for (const double z : {-4.5, 4.5}) scene.place(arches, translation(5 * i, 5, z));
    }
    MeshBuilder pier;
    add_box(pier, {-0.6, -0.1, -0.6}, {0.6, 5.05, 0.6});
    const int piers = scene.mesh(pier, stone);
    for (int i = -3; i <= 4; ++i) {
        for (const double z : {-4.5, 4.5}) scene.place(piers, translation(5 * i - 2.5, 0, z));
    }
    return scene.take();
}

}  // namespace aoscore::builtin
