#include "scene/builtin/arches.h"
#include "scene/builtin/atrium_parts.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <cmath>
#include <numbers>

/// Columns, arches, vaults and balustrades of the atrium.
namespace aoscore::builtin::atrium {
namespace {

using glm::dvec2;
using glm::dvec3;

/// One leaf of a capital: a strip that hugs the bell and curls outwards at its tip, about the direction +z.
void add_capital_leaf(MeshBuilder& mesh, double bell_radius_m, double foot_m, double height_m, double width_m,
                      int rows) {
    add_surface(mesh, rows > 4 ? 4 : 2, rows, [&](double u, double v) {
        const double across = (u - 0.5) * width_m * (1 - 0.75 * v * v * v);
        const double curl = v < 0.7 ? 0 : (v - 0.7) / 0.3;
        const double out = 0.012 + 0.045 * v + 0.07 * curl * curl - 0.6 * across * across / width_m;
        const double up = foot_m + height_m * (v - 0.22 * curl * curl);
        return dvec3(across, up, bell_radius_m + out);
    });
}

struct Order {
    double foot_m, springing_m;  ///< heights of the column's foot and of the arch's underside
    double radius_m, plinth_half_m, abacus_half_m;
    int segments, leaf_rows;
};

/// A column after the classical order: plinth, two tori with a scotia, tapering shaft, capital of two rows of
/// leaves.
MeshBuilder column(const Order& order) {
    const double r = order.radius_m, foot = order.foot_m, top = order.springing_m;
    const double plinth = 0.14, capital = 2.1 * r, abacus = 0.12;
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-order.plinth_half_m, foot - 0.05, -order.plinth_half_m},
                     {order.plinth_half_m, foot + plinth, order.plinth_half_m}, 0.012);
    const double half_pi = std::numbers::pi / 2;
    const double y = foot + plinth;
    Profile line{{0.9 * r, y - 0.02}, {1.22 * r, y - 0.02}};
    append_arc(line, {1.22 * r, y + 0.05}, {0.07, 0.05}, -half_pi, half_pi, 5);
    append_arc(line, {1.2 * r, y + 0.14}, {0.05, 0.04}, -half_pi, -3 * half_pi, 4);
    append_arc(line, {1.12 * r, y + 0.21}, {0.05, 0.03}, -half_pi, half_pi, 4);
    line.emplace_back(1.06 * r, y + 0.24);
    line.emplace_back(1.06 * r, y + 0.26);
    const double shaft_low = y + 0.30, shaft_high = top - abacus - capital;
    for (int i = 0; i <= 5; ++i) {
        const double t = i / 5.0;
        line.emplace_back(r * (1 - 0.14 * t * t), shaft_low + (shaft_high - 0.06 - shaft_low) * t);
    }
    const double neck = 0.86 * r;
    append_arc(line, {neck, shaft_high - 0.02}, {0.04, 0.03}, -half_pi, half_pi, 4);
    line.emplace_back(neck, shaft_high + 0.015);
    for (int i = 1; i <= 5; ++i) {
        const double t = i / 5.0;
        line.emplace_back(neck + 0.45 * r * t * t * t, shaft_high + 0.015 + (capital - 0.015) * t);
    }
    line.emplace_back(0.5 * r, top - abacus + 0.01);
    add_lathe(mesh, line, order.segments);
    for (int row = 0; row < 2; ++row) {
        MeshBuilder leaf;
        add_capital_leaf(leaf, neck + (row ? 0.02 : 0.0), shaft_high + 0.03, capital * (row ? 0.9 : 0.5),
                         0.72 * r, order.leaf_rows);
        for (int i = 0; i < 8; ++i) {
            mesh.append(leaf, rotation_y((i + 0.5 * row) * std::numbers::pi / 4));
        }
    }
    const double half = order.abacus_half_m;
    add_bevelled_box(mesh, {-half, top - abacus, -half}, {half, top + 0.03, half}, 0.025);
    return mesh;
}

enum class Archivolts { court, both };

/// An arcade wall of one bay, the court on -z, with an archivolt on its court face or on both.
MeshBuilder arch(double opening_m, double height_m, int segments, Archivolts archivolts) {
    MeshBuilder mesh;
    const Profile line = semicircular_arch(opening_m, opening_m, segments);
    add_arched_wall(mesh, line, kBay_m / 2, height_m, kWallHalf_m, Underside::open);
    const double face = kWallHalf_m;
    const Profile section{{0.03, -face - 0.035}, {0.14, -face - 0.035}, {0.17, -face - 0.06},
                          {0.22, -face - 0.06},  {0.22, -face + 0.05},  {0.03, -face + 0.05}};
    MeshBuilder archivolt;
    add_arch_moulding(archivolt, line, section);
    mesh.append(archivolt, glm::dmat4(1.0));
    if (archivolts == Archivolts::both) mesh.append(archivolt, quarter_turns_y(2));
    // Keystone.
    MeshBuilder key;
    add_bevelled_box(key, {-0.11, opening_m - 0.04, -face - 0.1}, {0.11, opening_m + 0.3, face + 0.1}, 0.015);
    mesh.append(key, glm::dmat4(1.0));
    return mesh;
}

constexpr double kRibHalf_m = 0.25;
/// Vaults reach this far into the walls and ribs around them.
constexpr double kEmbed_m = 0.03;

}  // namespace

MeshBuilder lower_column() {
    return column({kStep_m, kLowerSpringing_m, 0.27, 0.375, 0.4, 20, 5});
}
MeshBuilder upper_column() {
    return column({kUpperFloor_m + kParapet_m, kUpperSpringing_m, 0.16, 0.27, 0.39, 14, 4});
}

MeshBuilder corner_pier() {
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-0.4, -0.1, -0.4}, {0.4, kUpperFloor_m - 0.2, 0.4}, 0.03);
    add_bevelled_box(mesh, {-0.46, 0.05, -0.46}, {0.46, 0.45, 0.46}, 0.03);
    add_bevelled_box(mesh, {-0.46, kLowerSpringing_m - 0.15, -0.46}, {0.46, kLowerSpringing_m + 0.03, 0.46},
                     0.03);
    add_bevelled_box(mesh, {-0.38, kUpperFloor_m - 0.1, -0.38}, {0.38, kCornice_m + 0.05, 0.38}, 0.03);
    add_bevelled_box(mesh, {-0.43, kUpperSpringing_m - 0.12, -0.43}, {0.43, kUpperSpringing_m + 0.03, 0.43},
                     0.025);
    return mesh;
}

MeshBuilder lower_arch() {
    return arch(1.0, kUpperFloor_m - 0.2 - kLowerSpringing_m, 12, Archivolts::both);
}
MeshBuilder upper_arch() {
    return arch(1.105, kCornice_m + 0.1 - kUpperSpringing_m, 12, Archivolts::court);
}

/// A rib across a gallery, x from the arcade (negative) to the outer wall.
MeshBuilder gallery_rib() {
    MeshBuilder mesh;
    const double half = kGallery_m / 2;
    add_arched_wall(mesh, semicircular_arch(half - 0.17, kVaultRise_m - 0.12, 10), half + 0.1,
                    kUpperFloor_m - 0.25 - kLowerSpringing_m, kRibHalf_m, Underside::open);
    for (const double side : {-1.0, 1.0}) {
        const double low = side > 0 ? half - 0.2 : -half - 0.05, high = side > 0 ? half + 0.05 : -half + 0.2;
        add_bevelled_box(mesh, {low, -0.16, -kRibHalf_m - 0.03}, {high, 0.02, kRibHalf_m + 0.03}, 0.02);
        const double low2 = side > 0 ? half - 0.12 : -half - 0.05,
                     high2 = side > 0 ? half + 0.05 : -half + 0.12;
        add_bevelled_box(mesh, {low2, -0.42, -kRibHalf_m + 0.035}, {high2, -0.14, kRibHalf_m - 0.035}, 0.02);
    }
    return mesh;
}

MeshBuilder gallery_vault() {
    MeshBuilder mesh;
    add_groin_vault(mesh, semicircular_arch(kBay_m / 2 - kRibHalf_m + kEmbed_m, kVaultRise_m, 8),
                    semicircular_arch(kGallery_m / 2 + kEmbed_m, kVaultRise_m, 8), 5);
    return mesh;
}

MeshBuilder corner_vault() {
    MeshBuilder mesh;
    const double half = (kGallery_m + kWallHalf_m - kRibHalf_m) / 2 + kEmbed_m;
    const Profile line = semicircular_arch(half, kVaultRise_m, 8);
    add_groin_vault(mesh, line, line, 6);
    return mesh;
}

/// A pilaster of the lower floor against the outer wall, the plane z = 0 with the gallery on +z.
MeshBuilder pilaster() {
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-0.22, kStep_m - 0.05, -0.06}, {0.22, kLowerSpringing_m - 0.3, 0.1}, 0.012);
    add_bevelled_box(mesh, {-0.27, kStep_m - 0.06, -0.07}, {0.27, kStep_m + 0.28, 0.15}, 0.02);
    return mesh;
}

/// A balustrade between two upper columns, about the middle of a bay: plinth, balusters, handrail.
MeshBuilder balustrade() {
    MeshBuilder mesh;
    const double half = kBay_m / 2, foot = kUpperFloor_m, rail = kUpperFloor_m + kParapet_m;
    add_bevelled_box(mesh, {-half + 0.2, foot - 0.04, -0.17}, {half - 0.2, foot + 0.14, 0.17}, 0.02);
    add_bevelled_box(mesh, {-half + 0.2, rail - 0.15, -0.19}, {half - 0.2, rail - 0.01, 0.19}, 0.03);
    const double low = foot + 0.12, high = rail - 0.13;
    Profile line;
    for (const dvec2& p :
         {dvec2(0.055, 0), dvec2(0.055, 0.09), dvec2(0.035, 0.13), dvec2(0.075, 0.28), dvec2(0.07, 0.38),
          dvec2(0.035, 0.62), dvec2(0.03, 0.78), dvec2(0.05, 0.88), dvec2(0.055, 1)}) {
        line.emplace_back(p.x, low + (high - low) * p.y);
    }
    MeshBuilder baluster;
    add_lathe(baluster, line, 8);
    constexpr int kBalusters = 8;
    for (int i = 0; i < kBalusters; ++i) {
        mesh.append(baluster, translation((i - (kBalusters - 1) / 2.0) * 0.265, 0, 0));
    }
    return mesh;
}

/// A pedestal under an upper column, between two balustrades.
MeshBuilder pedestal() {
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-0.26, kUpperFloor_m - 0.05, -0.26},
                     {0.26, kUpperFloor_m + kParapet_m + 0.005, 0.26}, 0.02);
    return mesh;
}

}  // namespace aoscore::builtin::atrium
