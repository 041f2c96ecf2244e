#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace aoscore::builtin {
namespace {

/// Half a bar's thickness, the distance between bars, and the bars' distance from the wall, metres.
constexpr double kHalfBar_m = 0.01;
constexpr double kBarSpacing_m = 0.14;
constexpr double kFromWall_m = 0.25;

}  // namespace

/// Bars 2 cm thick before a wall, which methods on a depth buffer take for solid. Light passes between and
/// behind them, but a depth buffer as a height field has nothing behind (Jimenez et al., Practical Real-Time
/// Strategies for Accurate Indirect Occlusion, 2016, name it as the assumption that fails).
Scene generate_railing() {
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    const int iron = scene.material("iron", glm::vec3(0.2f));

    MeshBuilder room;
    add_box(room, {-4, -0.2, -0.2}, {4, 0, 4});
    add_box(room, {-4.1, -0.3, -0.3}, {4.1, 2.5, 0});
    scene.place(scene.mesh(room, plaster));

    MeshBuilder bar;
    add_box(bar, {-kHalfBar_m, -0.02, -kHalfBar_m}, {kHalfBar_m, 1.02, kHalfBar_m});
    const int bars = scene.mesh(bar, iron);
    for (int i = -14; i <= 14; ++i) scene.place(bars, translation(kBarSpacing_m * i, 0, kFromWall_m));

    MeshBuilder rail;
    add_bevelled_box(rail, {-2.05, 1, kFromWall_m - 0.03}, {2.05, 1.04, kFromWall_m + 0.03}, 0.005);
    scene.place(scene.mesh(rail, iron));
    return scene.take();
}

}  // namespace aoscore::builtin
