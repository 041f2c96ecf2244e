#include "scene/builtin/arches.h"
#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <cmath>
#include <numbers>

/// Paving, doors, beams, lamps and other smaller parts of the atrium.
namespace aoscore::builtin::atrium {

using glm::dvec2;
using glm::dvec3;

/// The court's floor: slabs with open joints, a few millimetres uneven.
MeshBuilder paving() {
    constexpr int kAlong = 20, kAcross = 7;
    constexpr double kJoint_m = 0.014;
    const double half_x = kHalfX_m - 0.57, half_z = kHalfZ_m - 0.57;
    const double length = 2 * half_x / kAlong, width = 2 * half_z / kAcross;
    MeshBuilder slabs;  // laid out in x,y, then turned to look up
    for (int k = 0; k < kAcross; ++k) {
        for (int i = 0; i < kAlong; ++i) {
            const double top = 0.004 * (hash_unit(3, static_cast<std::uint32_t>(k * kAlong + i)) - 0.5);
            const double x = i * length - half_x, y = k * width - half_z;
            add_raised_block(slabs, {x + kJoint_m / 2, y + kJoint_m / 2, -0.06},
                             {x + length - kJoint_m / 2, y + width - kJoint_m / 2, top}, 0.012);
        }
    }
    MeshBuilder mesh;
    mesh.append(slabs, rotation_x(-std::numbers::pi / 2));
    return mesh;
}

/// A panel that fills the arch of a lower bay behind the relief.
MeshBuilder blind_panel() {
    MeshBuilder mesh;
    add_box(mesh, {-kBay_m / 2, 0, -0.12}, {kBay_m / 2, kLowerSpringing_m + 1.1, 0.12});
    return mesh;
}

/// A wall fountain's bowl on its foot, half round: it stands out of the plane z = 0 towards +z.
MeshBuilder basin() {
    const double half_pi = std::numbers::pi / 2;
    Profile line{{0.3, -0.05}, {0.3, 0.06}};
    append_arc(line, {0.22, 0.1}, {0.05, 0.04}, -half_pi, half_pi, 4);
    line.insert(line.end(), {{0.15, 0.18}, {0.14, 0.36}, {0.2, 0.46}, {0.42, 0.56}, {0.6, 0.7}, {0.64, 0.8}});
    append_arc(line, {0.64, 0.84}, {0.045, 0.04}, -half_pi, half_pi, 5);
    line.insert(line.end(), {{0.6, 0.86}, {0.52, 0.72}, {0.35, 0.64}, {0, 0.6}});
    MeshBuilder mesh;
    add_part_lathe(mesh, line, 24, -half_pi, half_pi);
    return mesh;
}

/// A door in its frame on the outer wall's inner face, the plane z = 0, opening towards +z.
MeshBuilder door() {
    MeshBuilder mesh;
    const double foot = kStep_m - 0.05, head = kStep_m + 2.35;
    for (const double x : {-0.66, 0.66}) {
        add_raised_block(mesh, {x - 0.11, foot, -0.05}, {x + 0.11, head, 0.12}, 0.02);
    }
    add_bevelled_box(mesh, {-0.8, head - 0.03, -0.05}, {0.8, head + 0.2, 0.14}, 0.02);
    add_bevelled_box(mesh, {-0.88, head + 0.17, -0.06}, {0.88, head + 0.27, 0.2}, 0.025);
    for (const double x : {-0.285, 0.285}) {
        add_raised_block(mesh, {x - 0.28, foot + 0.01, -0.05}, {x + 0.28, head - 0.01, 0.04}, 0.008);
        for (int row = 0; row < 3; ++row) {
            const double low = kStep_m + 0.18 + 0.71 * row;
            add_raised_block(mesh, {x - 0.19, low, 0.0}, {x + 0.19, low + 0.56, 0.07}, 0.025);
        }
    }
    return mesh;
}

/// Two ceiling beams of an upper gallery bay, across the gallery (z from the arcade to the outer wall).
MeshBuilder beams() {
    MeshBuilder mesh;
    for (const double x : {-kBay_m / 4, kBay_m / 4}) {
        add_bevelled_box(mesh, {x - 0.11, kCornice_m - 0.28, 0},
                         {x + 0.11, kCornice_m + 0.1, kWallHalf_m + kGallery_m + 0.1}, 0.015);
        add_bevelled_box(mesh, {x - 0.09, kCornice_m - 0.5, 0.1},
                         {x + 0.09, kCornice_m - 0.25, kWallHalf_m + 0.35}, 0.03);
    }
    return mesh;
}

/// A bowl that hangs by three chains from a vault's crown (the origin).
MeshBuilder lamp() {
    MeshBuilder mesh;
    add_lathe(mesh, {{0, -0.06}, {0.06, -0.06}, {0.06, -0.02}, {0.02, 0.03}}, 8);
    const double rim = -1.05;
    add_lathe(mesh,
              {{0, rim - 0.2},
               {0.05, rim - 0.19},
               {0.14, rim - 0.13},
               {0.19, rim - 0.03},
               {0.2, rim},
               {0.215, rim + 0.02},
               {0.19, rim + 0.03},
               {0.17, rim - 0.03},
               {0.1, rim - 0.11},
               {0, rim - 0.15}},
              16);
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * std::numbers::pi * i / 3;
        const dvec3 low(0.2 * std::sin(angle), rim + 0.01, 0.2 * std::cos(angle)), high(0, -0.03, 0);
        const dvec3 axis = glm::normalize(high - low),
                    side = glm::normalize(glm::cross(axis, dvec3(0, 1, 0)));
        const dvec3 other = glm::cross(axis, side);
        add_surface(
            mesh, 5, 1,
            [&](double u, double v) {
                const double a = 2 * std::numbers::pi * u;
                return glm::mix(low, high, v) + 0.009 * (std::cos(a) * side + std::sin(a) * other);
            },
            true);
    }
    return mesh;
}

/// A flower in the spandrel between two arches; the wall is z = 0, the flower looks along +z.
MeshBuilder rosette() {
    MeshBuilder lathed, mesh;
    add_lathe(lathed,
              {{0.23, -0.03},
               {0.23, 0.02},
               {0.2, 0.045},
               {0.17, 0.02},
               {0.15, 0.015},
               {0.07, 0.015},
               {0.06, 0.05},
               {0.03, 0.065},
               {0, 0.068}},
              20);
    mesh.append(lathed, rotation_x(std::numbers::pi / 2));
    MeshBuilder petal;
    add_lathe(petal, {{1, -0.5}, {1, 0}, {0.6, 0.8}, {0, 1}}, 6);
    for (int i = 0; i < 8; ++i) {
        mesh.append(petal, rotation_z(i * std::numbers::pi / 4) * translation(0.105, 0, 0.02) *
                               scaling(0.05, 0.032, 0.03) * rotation_x(std::numbers::pi / 2));
    }
    return mesh;
}

/// The rows of round cover tiles on one slope of the roof, of which `half_length_m` a side runs along the
/// court. They end at the valleys, where the neighbouring slopes meet. z = 0 is the column axes' line, the
/// court on -z.
MeshBuilder roof_tiles(double half_length_m) {
    const dvec2 eave(-0.745, kCornice_m + 0.6), ridge(kWallHalf_m + kGallery_m, kTop_m - 0.27);
    constexpr double kPitch_m = kBay_m / 9;
    const int rows = static_cast<int>((half_length_m + ridge.x) / kPitch_m);
    MeshBuilder mesh;
    for (int row = -rows; row <= rows; ++row) {
        const double x = row * kPitch_m;
        const double start = std::max(0.0, (std::abs(x) + 0.1 - half_length_m - eave.x) / (ridge.x - eave.x));
        if (start > 0.95) continue;
        const dvec2 low = glm::mix(eave, ridge, start);
        add_surface(mesh, 5, 1, [&](double u, double v) {
            const double a = std::numbers::pi * u, radius = 0.1;
            const dvec2 p = glm::mix(low, ridge, v);
            return dvec3(x + radius * std::cos(a), p.y - 0.03 + radius * std::sin(a), p.x);
        });
        add_surface(mesh, 5, 1, [&](double u, double v) {  // the tile's closed lower end
            const double a = std::numbers::pi * u, radius = 0.1 * v;
            return dvec3(x + radius * std::cos(a), low.y - 0.03 + radius * std::sin(a), low.x);
        });
    }
    return mesh;
}

}  // namespace aoscore::builtin::atrium
