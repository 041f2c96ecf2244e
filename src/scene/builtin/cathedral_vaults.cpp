#include "scene/builtin/cathedral_parts.h"
#include "scene/builtin/scene_builder.h"

#include <cmath>
#include <numbers>

/// Ribbed vaults of the cathedral; y = 0 is their springing.
namespace aoscore::builtin::cathedral {
namespace {

using glm::dvec2;
using glm::dvec3;

/// A bay of vault: its arch across (along z) and the same arch, narrowed or widened, along x, so that their
/// groins lie in vertical planes.
struct Vault {
    double half_z_m, rise_m;
    int segments, rows;

    Profile across() const { return pointed_arch(half_z_m, rise_m, segments); }
    Profile along() const { return widened(across(), kBay_m / 2); }
};

constexpr Vault kNave{kNaveVaultHalf_m, kNaveRise_m, 12, 4};
constexpr Vault kAisle{kAisleVaultHalf_m, kAisleRise_m, 8, 3};

MeshBuilder webs(const Vault& vault) {
    MeshBuilder mesh;
    add_groin_vault(mesh, vault.along(), vault.across(), vault.rows);
    return mesh;
}

/// Diagonal ribs under the groins, a boss where they cross, and ribs along the two walls.
MeshBuilder ribs(const Vault& vault, double half_width_m) {
    MeshBuilder mesh;
    const Profile across = vault.across(), along = vault.along();
    Profile diagonal;
    for (std::size_t i = 0; i < across.size(); ++i) {
        diagonal.emplace_back(std::copysign(std::hypot(across[i].x, along[i].x), along[i].x), across[i].y);
    }
    const double w = half_width_m;
    const Profile section{{-1.5 * w, -0.35 * w}, {-0.7 * w, -w}, {0.4 * w, -w},
                          {0.4 * w, w},          {-0.7 * w, w},  {-1.5 * w, 0.35 * w}};
    const double angle = std::atan2(across.front().x, along.front().x);
    MeshBuilder rib;
    add_arch_moulding(rib, diagonal, section);
    mesh.append(rib, rotation_y(angle));
    mesh.append(rib, rotation_y(-angle));
    MeshBuilder boss;
    add_lathe(boss,
              {{0, -2.2 * w},
               {0.9 * w, -2.0 * w},
               {1.3 * w, -1.6 * w},
               {2 * w, -1.4 * w},
               {2.1 * w, -0.9 * w},
               {2 * w, 0.2 * w}},
              10);
    mesh.append(boss, translation(0, vault.rise_m, 0));
    MeshBuilder wall_rib;
    add_arch_moulding(wall_rib, along,
                      {{-w, -0.6 * w}, {0.4 * w, -0.9 * w}, {0.4 * w, 0.9 * w}, {-w, 0.6 * w}});
    for (const double side : {-1.0, 1.0})
        mesh.append(wall_rib, translation(0, 0, side * (vault.half_z_m - kEmbed_m)));
    return mesh;
}

}  // namespace

MeshBuilder nave_vault_webs() {
    return webs(kNave);
}
MeshBuilder nave_vault_ribs() {
    return ribs(kNave, 0.11);
}
MeshBuilder aisle_vault_webs() {
    return webs(kAisle);
}
MeshBuilder aisle_vault_ribs() {
    return ribs(kAisle, 0.09);
}

/// The arch between two bays, along x (turn it where it is needed).
MeshBuilder transverse_rib(double half_width_m, double rise_m, double half_thickness_m) {
    MeshBuilder mesh;
    const double w = half_thickness_m;
    add_arch_moulding(mesh, pointed_arch(half_width_m, rise_m, 10),
                      {{-1.1 * w, -0.4 * w},
                       {-0.8 * w, -0.75 * w},
                       {-0.45 * w, -0.75 * w},
                       {-0.3 * w, -w},
                       {0.2 * w, -w},
                       {0.2 * w, w},
                       {-0.3 * w, w},
                       {-0.45 * w, 0.75 * w},
                       {-0.8 * w, 0.75 * w},
                       {-1.1 * w, 0.4 * w}});
    return mesh;
}

/// One of the five webs over the apse, symmetric about the +x axis: straight between the ribs, the nave's
/// arch in height.
MeshBuilder apse_web() {
    const Profile arch = kNave.across();
    const int rows = static_cast<int>(arch.size()) / 2;
    const double half_turn = std::numbers::pi / 10;
    MeshBuilder mesh;
    add_surface(mesh, 4, rows, [&](double u, double v) {
        const dvec2 p = arch[static_cast<std::size_t>(std::lround(v * rows))];
        return dvec3(p.x * std::cos(half_turn), p.y, p.x * std::sin(half_turn) * (2 * u - 1));
    });
    return mesh;
}

/// The rib between two webs of the apse, in the half plane z = 0, x >= 0.
MeshBuilder apse_rib() {
    const Profile arch = kNave.across();
    const Profile half(arch.begin(), arch.begin() + static_cast<std::ptrdiff_t>(arch.size() / 2 + 1));
    MeshBuilder mesh;
    add_arch_moulding(
        mesh, half,
        {{-0.17, -0.04}, {-0.08, -0.11}, {0.06, -0.11}, {0.06, 0.11}, {-0.08, 0.11}, {-0.17, 0.04}});
    return mesh;
}

/// The shell above the apse's webs, the half about +x, a hand's breadth into the nave's end walls.
MeshBuilder apse_roof() {
    const Profile arch = kNave.across();
    Profile section;
    for (std::size_t i = 0; i <= arch.size() / 2; ++i)
        section.emplace_back(1.25 * arch[i].x, 1.06 * arch[i].y + 0.25);
    for (std::size_t i = arch.size() / 2 + 1; i-- > 0;)
        section.emplace_back(1.12 * arch[i].x, 1.04 * arch[i].y + 0.2);
    section.push_back(section.front());
    MeshBuilder mesh;
    add_part_lathe(mesh, section, 5, 0, std::numbers::pi);
    return mesh;
}

/// A slender shaft in a corner of the apse, about the y axis, from the floor to the springing of its rib.
MeshBuilder apse_shaft() {
    MeshBuilder mesh;
    const double top = kNaveSpringing_m;
    add_lathe(mesh,
              {{0.26, -0.1},
               {0.26, 0.2},
               {0.22, 0.26},
               {0.2, 0.3},
               {0.13, 0.34},
               {0.13, top - 0.5},
               {0.16, top - 0.47},
               {0.13, top - 0.43},
               {0.15, top - 0.28},
               {0.25, top - 0.12},
               {0.28, top - 0.1},
               {0.28, top + 0.02},
               {0, top + 0.03}},
              14);
    return mesh;
}

}  // namespace aoscore::builtin::cathedral
