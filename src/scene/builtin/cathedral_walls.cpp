#include "scene/builtin/cathedral_parts.h"
#include "scene/builtin/scene_builder.h"

#include <cmath>
#include <numbers>

/// Arcades, windows and portal of the cathedral.
namespace aoscore::builtin::cathedral {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Mullion, two lancets and a ring in a window about z = 0, its glass behind them; sill at y = 0.
MeshBuilder tracery(double half_width_m, double jamb_m, double rise_m) {
    MeshBuilder mesh;
    add_box(mesh, {-half_width_m - 0.06, -0.06, -0.03}, {half_width_m + 0.06, jamb_m + rise_m + 0.06, 0.03});
    const double half = half_width_m / 2;
    MeshBuilder post;
    add_lathe(post, {{0.05, -0.05}, {0.05, jamb_m + 0.15}, {0.0, jamb_m + 0.17}}, 8);
    mesh.append(post, glm::dmat4(1.0));
    const Profile lancet = stilted(pointed_arch(half - 0.05, 1.25 * half, 5), jamb_m);
    const Profile section{{-0.04, -0.07}, {0.04, -0.07}, {0.04, 0.07}, {-0.04, 0.07}};
    MeshBuilder bar;
    add_arch_moulding(bar, lancet, section);
    for (const double side : {-1.0, 1.0}) mesh.append(bar, translation(side * half, -0.05, 0));
    MeshBuilder ring;
    add_torus(ring, 0.42 * half_width_m, 0.045, 16, 5);
    mesh.append(ring, translation(0, jamb_m + 0.56 * rise_m, 0));
    return mesh;
}

/// A bay of wall with a glazed window, framed on the inner side (-z).
MeshBuilder window_bay(const WindowWall& wall, double half_width_m, double jamb_m, double rise_m) {
    MeshBuilder mesh;
    const Profile opening = stilted(pointed_arch(half_width_m, rise_m, 6), jamb_m);
    add_window_wall(mesh, opening, wall);
    mesh.append(tracery(half_width_m, jamb_m, rise_m), translation(0, wall.sill_m, 0.05));
    const double face = -wall.half_thickness_m;
    MeshBuilder frame;
    add_arch_moulding(frame, opening,
                      {{0.05, face - 0.05},
                       {0.11, face - 0.08},
                       {0.17, face - 0.04},
                       {0.17, face + 0.05},
                       {0.05, face + 0.05}});
    mesh.append(frame, translation(0, wall.sill_m, 0));
    add_bevelled_box(mesh, {-half_width_m - 0.25, wall.sill_m - 0.14, face - 0.13},
                     {half_width_m + 0.25, wall.sill_m + 0.02, face + 0.1}, 0.03);
    return mesh;
}

}  // namespace

/// One bay of the nave's arcade from its springing (y = 0) to the string course; the nave is on -z.
MeshBuilder arcade_arch() {
    MeshBuilder mesh;
    const Profile line = pointed_arch(1.85, 2.55, 10);
    add_arched_wall(mesh, line, kBay_m / 2, kString_m - kArcadeSpringing_m, kArcadeHalf_m);
    const double face = kArcadeHalf_m;
    MeshBuilder moulding;
    add_arch_moulding(moulding, line,
                      {{0.04, -face - 0.03},
                       {0.1, -face - 0.07},
                       {0.16, -face - 0.03},
                       {0.22, -face - 0.06},
                       {0.28, -face - 0.02},
                       {0.28, -face + 0.05},
                       {0.04, -face + 0.05}});
    mesh.append(moulding, glm::dmat4(1.0));
    mesh.append(moulding, quarter_turns_y(2));
    // The inner order: a roll under the soffit.
    add_arch_moulding(mesh, line,
                      {{-0.16, -0.1}, {-0.08, -0.2}, {0.06, -0.2}, {0.06, 0.2}, {-0.08, 0.2}, {-0.16, 0.1}});
    return mesh;
}

/// One bay of the nave's upper wall with its string course; the nave is on -z.
MeshBuilder clerestory_bay() {
    MeshBuilder mesh = window_bay({kBay_m / 2, kString_m, 9.7, kWallTop_m, kArcadeHalf_m}, 0.75, 1.5, 1.25);
    const double y = kString_m, face = -kArcadeHalf_m;
    // In (x, y) along z, turned to run along x.
    MeshBuilder run, course;
    add_run(run,
            {{0.05, y + 0.14},
             {-0.13, y + 0.08},
             {-0.13, y + 0.02},
             {-0.08, y - 0.02},
             {-0.05, y - 0.1},
             {0, y - 0.14},
             {0.05, y - 0.14}},
            -kBay_m / 2, kBay_m / 2);
    course.append(run, quarter_turns_y(-1));
    mesh.append(course, translation(0, 0, face));
    return mesh;
}

/// One bay of the outer wall; the aisle is on -z.
MeshBuilder aisle_wall_bay() {
    return window_bay({kBay_m / 2, -0.4, 2.4, kAisleTop_m, kOuterHalf_m}, 0.7, 1.9, 1.2);
}

/// One side of the apse (half a decagon about the nave's end), without its corners; the inside is on -z.
MeshBuilder apse_bay() {
    const double inner = kArcade_m - kArcadeHalf_m, half_turn = std::numbers::pi / 10;
    return window_bay({inner * std::sin(half_turn), -0.4, 3.2, kNaveSpringing_m + 0.3, 0.35}, 0.55, 3.6,
                      0.95);
}

/// The wall above the vault where nave and apse meet, on its springing (y = 0); its opening stays behind the
/// ribs.
MeshBuilder choir_arch() {
    MeshBuilder mesh;
    add_arched_wall(mesh, pointed_arch(kNaveVaultHalf_m + 0.03, kNaveRise_m + 0.03, 12), kArcade_m + 0.2,
                    kWallTop_m + 0.05 - kNaveSpringing_m, 0.3);
    return mesh;
}

/// The round window above the portal, on the wall x = 0 looking along +z.
MeshBuilder rose_window() {
    MeshBuilder mesh, rings;
    Profile section{{1.6, -0.05}, {1.6, 0.05}};
    append_arc(section, {1.5, 0.05}, {0.1, 0.09}, 0, std::numbers::pi, 6);
    section.insert(section.end(), {{1.34, 0.06}, {1.28, 0.02}, {1.24, 0.02}, {1.2, -0.05}});
    add_lathe(rings, section, 48);
    mesh.append(rings, rotation_x(std::numbers::pi / 2));
    MeshBuilder spoke, eye;
    add_lathe(spoke, {{0.05, 0.2}, {0.05, 1.25}}, 8);
    add_torus(eye, 0.27, 0.07, 24, 8);
    mesh.append(eye, translation(0, 0, 0.03));
    MeshBuilder foil;
    add_torus(foil, 0.19, 0.035, 14, 5);
    for (int i = 0; i < 12; ++i) {
        const glm::dmat4 turn = rotation_z(i * std::numbers::pi / 6);
        mesh.append(spoke, turn * translation(0, 0, 0.02));
        mesh.append(foil, turn * rotation_z(std::numbers::pi / 12) * translation(0, 0.97, 0.02));
    }
    return mesh;
}

/// A stepped, closed doorway on the wall z = 0, looking along +z.
MeshBuilder portal() {
    MeshBuilder mesh;
    for (int order = 0; order < 3; ++order) {
        const double half = 1.15 + 0.22 * order, out = 0.12 + 0.13 * order, foot = 0.04 + 0.005 * order;
        add_arch_moulding(
            mesh, stilted(pointed_arch(half, 1.5 + 0.22 * order, 10), 2.6),
            {{0.0, -foot}, {0.2, -foot}, {0.2, out - 0.05}, {0.15, out}, {0.06, out}, {0.0, out - 0.05}});
    }
    for (const double x : {-0.575, 0.575}) {
        MeshBuilder leaf;
        add_raised_block(leaf, {x - 0.57, -0.05, -0.02}, {x + 0.57, 2.6, 0.06}, 0.01);
        for (int row = 0; row < 4; ++row) {
            for (const double column : {-0.27, 0.27}) {
                add_raised_block(leaf, {x + column - 0.2, 0.12 + 0.62 * row, 0.04},
                                 {x + column + 0.2, 0.62 + 0.62 * row, 0.1}, 0.03);
            }
        }
        mesh.append(leaf, glm::dmat4(1.0));
    }
    add_bevelled_box(mesh, {-1.2, 2.58, -0.06}, {1.2, 2.8, 0.1}, 0.02);
    return mesh;
}

}  // namespace aoscore::builtin::cathedral
