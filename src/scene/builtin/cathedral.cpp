#include "scene/builtin/cathedral_parts.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"

#include <cmath>
#include <numbers>

namespace aoscore::builtin {

namespace cathedral {

/// The floor's slabs over nave and aisles, with open joints.
MeshBuilder paving() {
    constexpr int kAlong = 22, kAcross = 9;
    const double half_x = kHalfLength_m + 0.1, half_y = kOuterWall_m - kOuterHalf_m + 0.1;
    MeshBuilder slabs, mesh;
    for (int k = 0; k < kAcross; ++k) {
        for (int i = 0; i < kAlong; ++i) {
            const double x = (2.0 * i / kAlong - 1) * half_x, y = (2.0 * k / kAcross - 1) * half_y;
            const double top = 0.004 * (hash_unit(5, static_cast<std::uint32_t>(k * kAlong + i)) - 0.5);
            add_raised_block(slabs, {x + 0.007, y + 0.007, -0.06},
                             {x + 2 * half_x / kAlong - 0.007, y + 2 * half_y / kAcross - 0.007, top}, 0.012);
        }
    }
    mesh.append(slabs, rotation_x(-std::numbers::pi / 2));
    return mesh;
}

/// A pew, facing east, about its middle.
MeshBuilder bench() {
    MeshBuilder mesh;
    for (const double z : {-1.3, 1.3})
        add_bevelled_box(mesh, {-0.3, -0.05, z - 0.04}, {0.25, 0.95, z + 0.04}, 0.012);
    add_box(mesh, {-0.21, 0.42, -1.3}, {0.22, 0.46, 1.3});
    add_box(mesh, {-0.24, 0.3, -1.31}, {-0.19, 0.9, 1.31});
    add_box(mesh, {-0.27, 0.62, -1.29}, {-0.23, 0.66, 1.29});
    return mesh;
}

/// Three steps across the nave and the altar above them.
MeshBuilder altar() {
    MeshBuilder mesh;
    for (int step = 0; step < 3; ++step) {
        add_bevelled_box(mesh, {-3.2 + 0.4 * step, -0.09 + 0.01 * step, -3.37 + 0.12 * step},
                         {3.4 - 0.1 * step, 0.16 * (step + 1), 3.37 - 0.12 * step}, 0.015);
    }
    add_bevelled_box(mesh, {0.4, 0.4, -1.1}, {1.2, 1.4, 1.1}, 0.02);
    add_bevelled_box(mesh, {0.3, 1.38, -1.25}, {1.3, 1.5, 1.25}, 0.02);
    for (const double z : {-0.7, 0.7}) {
        MeshBuilder candlestick;
        add_lathe(candlestick,
                  {{0.12, -0.02},
                   {0.12, 0.02},
                   {0.03, 0.06},
                   {0.05, 0.14},
                   {0.025, 0.2},
                   {0.025, 0.5},
                   {0.07, 0.55},
                   {0.03, 0.56},
                   {0.03, 0.9},
                   {0, 0.92}},
                  10);
        mesh.append(candlestick, translation(0.8, 1.5, z));
    }
    return mesh;
}

}  // namespace cathedral

namespace {

using namespace cathedral;

/// Placement of a part on one side of the church: its -z looks to the nave; `along` is its x on the +z side.
glm::dmat4 side_place(int side, double along, double from_middle_m) {
    return quarter_turns_y(2 * side) * translation(along, 0, from_middle_m);
}

void add_bays(SceneBuilder& scene, int stone, int plaster) {
    const int arches = scene.mesh(arcade_arch(), stone), clerestories = scene.mesh(clerestory_bay(), plaster);
    const int outer_walls = scene.mesh(aisle_wall_bay(), plaster);
    const int nave_webs = scene.mesh(nave_vault_webs(), plaster),
              nave_ribs = scene.mesh(nave_vault_ribs(), stone);
    const int aisle_webs = scene.mesh(aisle_vault_webs(), plaster),
              aisle_ribs = scene.mesh(aisle_vault_ribs(), stone);
    const double aisle_middle = kArcade_m + kArcadeHalf_m + kAisle_m / 2;
    for (int i = 0; i < kBays; ++i) {
        const double x = (i - (kBays - 1) / 2.0) * kBay_m;
        scene.place(nave_webs, translation(x, kNaveSpringing_m, 0));
        scene.place(nave_ribs, translation(x, kNaveSpringing_m, 0));
        for (const int side : {0, 1}) {
            scene.place(arches, side_place(side, x, kArcade_m) * translation(0, kArcadeSpringing_m, 0));
            scene.place(clerestories, side_place(side, x, kArcade_m));
            scene.place(outer_walls, side_place(side, x, kOuterWall_m));
            const glm::dmat4 vault =
                side_place(side, x, aisle_middle) * translation(0, kArcadeSpringing_m, 0);
            scene.place(aisle_webs, vault);
            scene.place(aisle_ribs, vault);
        }
    }
    const int piers = scene.mesh(pier(), stone), shafts = scene.mesh(vaulting_shafts(), stone);
    const int responds = scene.mesh(respond(), stone);
    const int nave_arches = scene.mesh(transverse_rib(kNaveVaultHalf_m, kNaveRise_m, 0.26), stone);
    const int aisle_arches = scene.mesh(transverse_rib(kAisleVaultHalf_m, kAisleRise_m, 0.2), stone);
    for (int i = 0; i <= kBays; ++i) {
        const double x = (i - kBays / 2.0) * kBay_m;
        scene.place(nave_arches, translation(x, kNaveSpringing_m, 0) * quarter_turns_y(1));
        for (const int side : {0, 1}) {
            scene.place(piers, side_place(side, x, kArcade_m));
            scene.place(shafts, side_place(side, x, kArcade_m - kArcadeHalf_m) * quarter_turns_y(2));
            scene.place(responds, side_place(side, x, kOuterWall_m - kOuterHalf_m) * quarter_turns_y(2));
            scene.place(aisle_arches, side_place(side, x, aisle_middle) *
                                          translation(0, kArcadeSpringing_m, 0) * quarter_turns_y(1));
        }
    }
}

/// Adds the apse: five sides of a decagon about the nave's east end.
void add_apse(SceneBuilder& scene, int stone, int plaster) {
    const int walls = scene.mesh(apse_bay(), plaster), webs = scene.mesh(apse_web(), plaster);
    const int ribs = scene.mesh(apse_rib(), stone), shafts = scene.mesh(apse_shaft(), stone);
    MeshBuilder corner;
    add_bevelled_box(corner, {0.12, -0.4, -0.4}, {1.0, kNaveSpringing_m + 0.5, 0.4}, 0.04);
    const int buttresses = scene.mesh(corner, stone);
    const double inner = kArcade_m - kArcadeHalf_m, side_turn = std::numbers::pi / 5;
    const glm::dmat4 centre = translation(kHalfLength_m, 0, 0);
    scene.place(scene.mesh(choir_arch(), plaster),
                centre * translation(0.32, kNaveSpringing_m, 0) * quarter_turns_y(1));
    for (int i = -2; i <= 2; ++i) {
        const glm::dmat4 turn = centre * rotation_y(i * side_turn);
        scene.place(walls,
                    turn * translation(inner * std::cos(side_turn / 2) + 0.35, 0, 0) * quarter_turns_y(1));
        scene.place(webs, turn * translation(0, kNaveSpringing_m, 0));
    }
    for (int i = 0; i <= 5; ++i) {
        const glm::dmat4 turn = centre * rotation_y((i - 2.5) * side_turn);
        scene.place(shafts, turn * translation(inner, 0, 0));
        scene.place(buttresses, turn * translation(inner, 0, 0));
        if (i > 0 && i < 5) scene.place(ribs, turn * translation(0, kNaveSpringing_m, 0));
    }
}

/// Adds ground, end walls and roofs.
void add_shell(SceneBuilder& scene, int stone, int plaster, int tiles) {
    const double outer = kOuterWall_m + kOuterHalf_m, nave = kArcade_m + kArcadeHalf_m, end = kHalfLength_m;
    MeshBuilder ground;
    add_box(ground, {-end - 1.2, -0.6, -outer - 0.4}, {end + 5.5, -0.03, outer + 0.4});
    scene.place(scene.mesh(ground, stone));
    scene.place(scene.mesh(cathedral::paving(), stone));

    MeshBuilder walls;
    add_box(walls, {-end - 0.9, -0.5, -outer - 0.1}, {-end, kString_m - 0.1, outer + 0.1});
    add_box(walls, {-end - 0.85, kString_m - 0.2, -nave - 0.05},
            {-end + 0.04, kWallTop_m + 0.2, nave + 0.05});
    for (const double side : {-1.0, 1.0}) {
        const double inner_z = kArcade_m - kArcadeHalf_m + 0.06;
        const auto block = [&](double x0, double x1, double y0, double y1, double z0, double z1) {
            add_box(walls, {x0, y0, side > 0 ? z0 : -z1}, {x1, y1, side > 0 ? z1 : -z0});
        };
        block(end - 0.05, end + 0.8, -0.5, kString_m - 0.1, inner_z, outer + 0.1);
        block(end - 0.02, end + 0.75, kString_m - 0.2, kWallTop_m + 0.2, inner_z + 0.02, nave + 0.05);
    }
    scene.place(scene.mesh(walls, plaster));

    MeshBuilder roofs;
    // The nave's gable and the aisles' lean-to roofs, drawn in (z, y) and run along x.
    MeshBuilder gable, lean_to;
    add_prism(gable, {{-nave - 0.5, kWallTop_m - 0.1}, {nave + 0.5, kWallTop_m - 0.1}, {0, kWallTop_m + 3.2}},
              -end - 0.8, end + 0.7);
    roofs.append(gable, quarter_turns_y(1));
    add_prism(lean_to,
              {{nave - 0.1, kString_m - 0.35},
               {outer + 0.4, kAisleTop_m - 0.25},
               {outer + 0.4, kAisleTop_m - 0.1},
               {nave - 0.1, kString_m + 0.6}},
              -end - 0.7, end + 0.6);
    roofs.append(lean_to, quarter_turns_y(1));
    roofs.append(lean_to, quarter_turns_y(3));
    scene.place(scene.mesh(apse_roof(), tiles), translation(end, kNaveSpringing_m, 0));
    scene.place(scene.mesh(roofs, tiles));
}

void add_furniture(SceneBuilder& scene, int stone, int wood) {
    const int benches = scene.mesh(bench(), wood);
    for (int row = 0; row < 13; ++row) {
        for (const double z : {-1.85, 1.85}) scene.place(benches, translation(-13 + 1.15 * row, 0, z));
    }
    scene.place(scene.mesh(altar(), stone), translation(kHalfLength_m - 1, 0, 0));
    const glm::dmat4 west = translation(-kHalfLength_m, 0, 0) * quarter_turns_y(1);
    scene.place(scene.mesh(portal(), stone), west);
    scene.place(scene.mesh(rose_window(), stone), west * translation(0, 10.6, 0.04));
}

}  // namespace

Scene generate_cathedral() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.6f, 0.58f, 0.53f));
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.73f, 0.68f));
    const int tiles = scene.material("roof", glm::vec3(0.3f, 0.3f, 0.32f));
    const int wood = scene.material("wood", glm::vec3(0.4f, 0.27f, 0.16f));
    add_shell(scene, stone, plaster, tiles);
    add_bays(scene, stone, plaster);
    add_apse(scene, stone, plaster);
    add_furniture(scene, stone, wood);
    return scene.take();
}

}  // namespace aoscore::builtin
