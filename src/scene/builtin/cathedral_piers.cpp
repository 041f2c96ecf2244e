#include "scene/builtin/cathedral_parts.h"
#include "scene/builtin/scene_builder.h"

#include <numbers>

/// Clustered piers and wall shafts of the cathedral.
namespace aoscore::builtin::cathedral {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;

/// The outline of a shaft with attic base and bell capital, from `foot` to `top`.
Profile shaft_line(double radius_m, double foot_m, double top_m) {
    const double r = radius_m;
    Profile line{{1.35 * r, foot_m}, {1.35 * r, foot_m + 0.05}};
    append_arc(line, {1.25 * r, foot_m + 0.1}, {0.22 * r, 0.05}, -kHalfPi, kHalfPi, 3);
    line.insert(line.end(), {{1.08 * r, foot_m + 0.21}, {1.15 * r, foot_m + 0.25}, {r, foot_m + 0.3}});
    line.insert(line.end(), {{r, top_m - 0.5}, {1.16 * r, top_m - 0.47}, {1.02 * r, top_m - 0.42}});
    line.insert(line.end(), {{1.1 * r, top_m - 0.25}, {1.45 * r, top_m - 0.1}, {1.45 * r, top_m}});
    return line;
}

void add_shaft(MeshBuilder& mesh, double x, double z, double radius_m, double foot_m, double top_m,
               int segments) {
    MeshBuilder shaft;
    add_lathe(shaft, shaft_line(radius_m, foot_m, top_m), segments);
    mesh.append(shaft, translation(x, 0, z));
}

}  // namespace

/// Four strong shafts along the axes and four slender ones between them, about a square core turned by 45
/// degrees.
MeshBuilder pier() {
    MeshBuilder mesh;
    const double top = kArcadeSpringing_m;
    MeshBuilder core;
    add_bevelled_box(core, {-0.42, -0.05, -0.42}, {0.42, top - 0.06, 0.42}, 0.08);
    mesh.append(core, rotation_y(std::numbers::pi / 4));
    add_bevelled_box(mesh, {-0.72, -0.1, -0.72}, {0.72, 0.22, 0.72}, 0.04);
    for (const double side : {-1.0, 1.0}) {
        add_shaft(mesh, side * 0.43, 0, 0.2, 0.2, top - 0.1, 10);
        add_shaft(mesh, 0, side * 0.43, 0.2, 0.2, top - 0.1, 10);
        for (const double other : {-1.0, 1.0})
            add_shaft(mesh, side * 0.34, other * 0.34, 0.1, 0.19, top - 0.11, 6);
    }
    add_bevelled_box(mesh, {-0.84, top - 0.13, -0.84}, {0.84, top + 0.04, 0.84}, 0.05);
    return mesh;
}

/// Three shafts on the nave's wall above a pier, up to the vault; the wall is z = 0, the nave on +z.
MeshBuilder vaulting_shafts() {
    MeshBuilder mesh;
    const double foot = kArcadeSpringing_m + 0.025, top = kNaveSpringing_m;
    add_shaft(mesh, 0, 0.1, 0.13, foot, top - 0.1, 10);
    for (const double side : {-1.0, 1.0})
        add_shaft(mesh, side * 0.24, 0.03, 0.09, foot - 0.01, top - 0.11, 6);
    add_bevelled_box(mesh, {-0.42, top - 0.13, -0.1}, {0.42, top + 0.03, 0.33}, 0.04);
    return mesh;
}

/// Half a pier against the aisle's outer wall, the plane z = 0 with the aisle on +z.
MeshBuilder respond() {
    MeshBuilder mesh;
    const double top = kArcadeSpringing_m;
    add_bevelled_box(mesh, {-0.5, -0.1, -0.1}, {0.5, 0.22, 0.42}, 0.03);
    add_bevelled_box(mesh, {-0.33, 0.1, -0.08}, {0.33, top - 0.06, 0.1}, 0.03);
    add_shaft(mesh, 0, 0.12, 0.18, 0.2, top - 0.1, 10);
    for (const double side : {-1.0, 1.0}) add_shaft(mesh, side * 0.3, 0.09, 0.1, 0.19, top - 0.11, 6);
    add_bevelled_box(mesh, {-0.5, top - 0.13, -0.11}, {0.5, top + 0.04, 0.45}, 0.04);
    return mesh;
}

}  // namespace aoscore::builtin::cathedral
