#include "scene/builtin/arches.h"
#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <cmath>
#include <numbers>

namespace aoscore::builtin {
namespace {

constexpr double kCourtBay_m = 3, kArcadeHalf_m = 0.25, kArcadeHeight_m = 4;
constexpr int kCourtBays = 6;                                  ///< bays of a side
constexpr double kCourtHalf_m = kCourtBay_m * kCourtBays / 2;  ///< half the court, to the arcades' middle
constexpr double kCourtGallery_m = 3;                          ///< clear depth behind an arcade
constexpr double kTurn_rad = 2 * std::numbers::pi;

void add_arcades(SceneBuilder& scene, int stone, int plaster) {
    const double outer = kArcadeHalf_m + kCourtGallery_m;  // depth of a gallery, from the arcades' middle
    MeshBuilder shell;
    const double half = kCourtHalf_m + outer + 0.4;
    add_box(shell, {-half, -0.4, -half}, {half, 0, half});
    const auto ring = [&](double inside, double outside, double low, double high) {
        add_frame(shell, {{outside, low}, {outside, high}, {inside, high}, {inside, low}, {outside, low}},
                  kCourtHalf_m, kCourtHalf_m);
    };
    ring(outer, outer + 0.3, -0.2, kArcadeHeight_m + 0.5);
    ring(-0.5, outer + 0.35, kArcadeHeight_m - 0.1, kArcadeHeight_m + 0.25);
    scene.place(scene.mesh(shell, plaster));

    MeshBuilder arch;
    add_arched_wall(arch, stilted(semicircular_arch(1.1, 1.1, 10), 2.1), kCourtBay_m / 2, kArcadeHeight_m,
                    kArcadeHalf_m, Underside::open);
    const int arches = scene.mesh(arch, stone);
    MeshBuilder corner;
    add_box(corner, {-0.26, -0.1, -0.26}, {0.26, kArcadeHeight_m + 0.1, 0.26});
    const int corners = scene.mesh(corner, stone);
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < kCourtBays; ++i)
            scene.place(arches, quarter_turns_y(side) *
                                    translation(kCourtBay_m * (i - (kCourtBays - 1) / 2.0), 0, kCourtHalf_m));
        scene.place(corners, quarter_turns_y(side) * translation(kCourtHalf_m, 0, kCourtHalf_m));
    }
}

MeshBuilder trunk() {
    MeshBuilder mesh;
    add_lathe(mesh, {{0.3, -0.1}, {0.2, 0.3}, {0.15, 1.4}, {0.11, 2.6}, {0.05, 3.6}, {0, 3.7}}, 10);
    return mesh;
}

/// Places a crown: rings of fronds that droop more the lower they grow.
void place_crown(SceneBuilder& scene, int fronds, const glm::dmat4& tree, std::uint32_t seed) {
    constexpr int kRings = 9, kFronds = 13;
    std::uint32_t index = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double height = static_cast<double>(ring) / (kRings - 1);
        for (int i = 0; i < kFronds; ++i, ++index) {
            const double around = kTurn_rad * (i + hash_unit(seed, 3 * index)) / kFronds;
            const double lean = 1.2 - 1.1 * height + 0.4 * (hash_unit(seed, 3 * index + 1) - 0.5);
            const double size = 1.1 + 0.5 * hash_unit(seed, 3 * index + 2);
            scene.place(fronds, tree * translation(0, 1.9 + 1.7 * height, 0) * rotation_y(around) *
                                    rotation_x(lean) * scaling(size, size, size));
        }
    }
}

void add_trees(SceneBuilder& scene) {
    const int bark = scene.material("bark", glm::vec3(0.3f, 0.22f, 0.15f));
    const int leaf = scene.cutout_material("leaf", atrium::frond_texture(), 0.5f);
    const int trunks = scene.mesh(trunk(), bark), fronds = scene.mesh(atrium::frond(), leaf);
    std::uint32_t seed = 31;
    for (const double x : {-4.0, 0.0, 4.0}) {
        for (const double z : {-4.0, 4.0}) {
            const glm::dmat4 tree = translation(x, 0, z) * rotation_y(kTurn_rad * hash_unit(seed, 0)) *
                                    scaling(1, 0.9 + 0.3 * hash_unit(seed, 1), 1);
            scene.place(trunks, tree);
            place_crown(scene, fronds, tree, ++seed);
        }
    }
}

MeshBuilder table() {
    MeshBuilder mesh;
    add_lathe(mesh,
              {{0.28, -0.02}, {0.28, 0.03}, {0.05, 0.07}, {0.04, 0.7}, {0.5, 0.72}, {0.5, 0.75}, {0, 0.75}},
              20);
    return mesh;
}

MeshBuilder chair() {
    MeshBuilder mesh;
    for (const double x : {-0.18, 0.18}) {
        for (const double z : {-0.18, 0.18})
            add_box(mesh, {x - 0.02, -0.02, z - 0.02}, {x + 0.02, z < 0 ? 0.9 : 0.46, z + 0.02});
    }
    add_bevelled_box(mesh, {-0.22, 0.43, -0.17}, {0.22, 0.47, 0.22}, 0.01);
    for (int i = 0; i < 3; ++i)
        add_box(mesh, {-0.19, 0.55 + 0.12 * i, -0.195}, {0.19, 0.61 + 0.12 * i, -0.165});
    return mesh;
}

void add_furniture(SceneBuilder& scene, int stone) {
    const int wood = scene.material("wood", glm::vec3(0.45f, 0.3f, 0.18f));
    const int tables = scene.mesh(table(), wood), chairs = scene.mesh(chair(), wood);
    const int planters = scene.mesh(atrium::planter(), stone);
    std::uint32_t seed = 51;
    for (const double x : {-6.0, -2.0, 2.0, 6.0}) {
        for (const double z : {-6.3, 0.0, 6.3}) {
            const glm::dmat4 place = translation(x, 0, z) * rotation_y(kTurn_rad * hash_unit(seed++, 0));
            scene.place(tables, place);
            for (int i = 0; i < 4; ++i)
                scene.place(chairs, place * rotation_y(kTurn_rad * i / 4 + 0.3 * hash_unit(seed++, 0)) *
                                        translation(0, 0, -0.75));
        }
    }
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i + 1 < kCourtBays; ++i)
            scene.place(planters,
                        quarter_turns_y(side) *
                            translation(kCourtBay_m * (i - (kCourtBays - 2) / 2.0), 0, kCourtHalf_m - 0.75));
    }
}

}  // namespace

/// Many instances and foliage under the sky, which stand in for San Miguel of Vermeer, Stochastic-Depth
/// Ambient Occlusion, 2020, table 9.1: arcades about a court with trees of cut-out fronds, tables and chairs.
Scene generate_courtyard() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.55f));
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    add_arcades(scene, stone, plaster);
    add_trees(scene);
    add_furniture(scene, stone);
    return scene.take();
}

}  // namespace aoscore::builtin
