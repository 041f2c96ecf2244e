#include "scene/builtin/arches.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <numbers>

namespace aoscore::builtin {
namespace {

constexpr double kVaultHalf_m = 2, kVaultSpringing_m = 2, kVaultLength_m = 9;
/// Normals are smoothed over edges that turn by less than this, where the surface itself stays faceted.
constexpr double kSmooth_rad = 50.0 * std::numbers::pi / 180.0;

MeshBuilder barrel() {
    MeshBuilder mesh;
    const Profile arch = semicircular_arch(kVaultHalf_m, kVaultHalf_m, 3);
    for (std::size_t i = 0; i + 1 < arch.size(); ++i) {
        const auto at = [&](std::size_t k, double z) {
            return glm::dvec3(arch[k].x, kVaultSpringing_m + arch[k].y, z);
        };
        mesh.quad(at(i, 0), at(i, kVaultLength_m), at(i + 1, kVaultLength_m), at(i + 1, 0));
    }
    return mesh;
}

}  // namespace

/// Few triangles under smooth normals, after figures 4.6 and 4.9 in Vermeer, Stochastic-Depth Ambient
/// Occlusion, 2020: a barrel vault of six strips, a column of eight sides and a sphere of 80 triangles.
/// Methods that use smooth normals darken points that lie below the surface which the normals imply.
Scene generate_vault() {
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    const int stone = scene.material("stone", glm::vec3(0.55f));

    MeshBuilder room;
    add_box(room, {-kVaultHalf_m - 0.2, -0.3, -0.3}, {kVaultHalf_m + 0.2, 0, kVaultLength_m + 0.1});
    add_box(room, {-kVaultHalf_m - 0.4, -0.4, -0.5}, {kVaultHalf_m + 0.4, 4.3, 0});
    add_box(room, {-kVaultHalf_m - 0.3, -0.2, -0.2},
            {-kVaultHalf_m, kVaultSpringing_m, kVaultLength_m - 0.05});
    add_box(room, {kVaultHalf_m, -0.2, -0.2}, {kVaultHalf_m + 0.3, kVaultSpringing_m, kVaultLength_m - 0.05});
    scene.place(scene.mesh(room, plaster));
    scene.place(scene.mesh(barrel(), plaster, kSmooth_rad));

    MeshBuilder column;
    add_lathe(column, {{0.3, -0.05}, {0.3, 2.4}, {0.42, 2.7}, {0, 2.7}}, 8);
    const int columns = scene.mesh(column, stone, kSmooth_rad);
    for (const double x : {-1.55, 1.55}) scene.place(columns, translation(x, 0, 3));

    MeshBuilder ball;
    add_sphere(ball, {0, 0.65, 2.5}, 0.7, 1);
    scene.place(scene.mesh(ball, stone, kSmooth_rad));
    return scene.take();
}

}  // namespace aoscore::builtin
