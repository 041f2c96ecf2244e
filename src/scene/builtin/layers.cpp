#include "scene/builtin/arches.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <array>

namespace aoscore::builtin {
namespace {

constexpr double kBayWidth_m = 4;
constexpr double kWallHeight_m = 3.5;
/// The distance of the screens' front, and the depth of all boards of a screen.
constexpr double kScreenFront_m = 4, kScreenDepth_m = 0.31;
/// Boards of each bay's screen. A board is two layers of depth, its front and its back.
constexpr std::array kBoards{1, 2, 4, 8, 16};

/// A screen of boards one behind the other, as far apart as they are thick.
MeshBuilder screen(int boards) {
    const double step = kScreenDepth_m / (2 * boards - 1);
    MeshBuilder mesh;
    for (int i = 0; i < boards; ++i) {
        const double front = kScreenFront_m - 2 * i * step;
        add_box(mesh, {-0.38, -0.05, front - step}, {0.38, 2.2, front});
    }
    return mesh;
}

}  // namespace

/// Occlusion from behind many layers of depth, after the scenario of figure 9.7 in Vermeer, Stochastic-Depth
/// Ambient Occlusion, 2020: five bays, in each of which crates against the back wall stand hidden behind a
/// screen of 2, 4, 8, 16 or 32 layers. An arch before each bay shows false occlusion by too many directions.
Scene generate_layers() {
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    const int stone = scene.material("stone", glm::vec3(0.55f));
    const int wood = scene.material("wood", glm::vec3(0.45f, 0.3f, 0.18f));
    const int bays = static_cast<int>(kBoards.size());
    const double half = kBayWidth_m * bays / 2;

    MeshBuilder room;
    add_box(room, {-half, -0.3, -0.3}, {half, 0, 12});
    add_box(room, {-half - 0.2, -0.4, -0.4}, {half + 0.2, kWallHeight_m + 0.3, 0});
    add_box(room, {-half, kWallHeight_m - 0.05, -0.3}, {half, kWallHeight_m + 0.2, 1.9});
    scene.place(scene.mesh(room, plaster));

    MeshBuilder piers;
    for (const double x : {-half, half}) add_box(piers, {x - 0.15, -0.1, 1.38}, {x + 0.15, 3.55, 1.82});
    scene.place(scene.mesh(piers, stone));

    MeshBuilder arch;
    add_arched_wall(arch, stilted(semicircular_arch(1.5, 1.1, 12), 2.0), kBayWidth_m / 2, kWallHeight_m, 0.2,
                    Underside::open);
    const int arches = scene.mesh(arch, stone);
    MeshBuilder crates;
    add_crates(crates, 2);
    const int hidden = scene.mesh(crates, wood);
    for (int i = 0; i < bays; ++i) {
        const double x = kBayWidth_m * (i - (bays - 1) / 2.0);
        scene.place(arches, translation(x, 0, 1.6));
        scene.place(hidden, translation(x, 0, 0));
        scene.place(scene.mesh(screen(kBoards[static_cast<std::size_t>(i)]), stone), translation(x, 0, 0));
    }
    return scene.take();
}

}  // namespace aoscore::builtin
