#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace aoscore::builtin {

/// Surfaces that a camera sees only at a grazing angle, after figures 9.20 and 9.22 in Vermeer,
/// Stochastic-Depth Ambient Occlusion, 2020: a board at right angles to the back wall, whose sides the view
/// `edge_on` cannot see, and a side wall that the views `corner_…` turn towards their line of sight.
Scene generate_grazing() {
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    const int wood = scene.material("wood", glm::vec3(0.45f, 0.3f, 0.18f));

    MeshBuilder room;
    add_box(room, {-4.1, -0.3, -0.3}, {5, 0, 8});
    add_box(room, {-4.2, -0.4, -0.4}, {5.1, 3.2, 0});
    add_box(room, {-4.3, -0.5, -0.35}, {-4, 3.3, 7.9});
    scene.place(scene.mesh(room, plaster));

    MeshBuilder board;
    add_box(board, {-0.05, -0.05, -0.05}, {0.05, 2.1, 1.2});
    scene.place(scene.mesh(board, wood));
    return scene.take();
}

}  // namespace aoscore::builtin
