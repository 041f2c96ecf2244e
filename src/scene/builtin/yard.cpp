#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <array>

namespace aoscore::builtin {
namespace {

using glm::dvec3;

constexpr double kPitDepth_m = 0.8;
// Lines of the floor's grid; the cell from column 4 and row 3 is the pit.
constexpr std::array<double, 8> kColumns_m = {-8, -4, -2, 0, 1, 2.6, 4, 8};
constexpr std::array<double, 7> kRows_m = {-8, -4, -2, -0.2, 1.4, 4, 8};
constexpr std::size_t kPitColumn = 4, kPitRow = 3;

void add_level(MeshBuilder& mesh, double x0, double x1, double z0, double z1, double y) {
    mesh.quad({x0, y, z1}, {x1, y, z1}, {x1, y, z0}, {x0, y, z0});
}

MeshBuilder floor_with_pit() {
    MeshBuilder mesh;
    for (std::size_t row = 0; row + 1 < kRows_m.size(); ++row) {
        for (std::size_t column = 0; column + 1 < kColumns_m.size(); ++column) {
            const bool pit = row == kPitRow && column == kPitColumn;
            add_level(mesh, kColumns_m[column], kColumns_m[column + 1], kRows_m[row], kRows_m[row + 1],
                      pit ? -kPitDepth_m : 0);
        }
    }
    const double x0 = kColumns_m[kPitColumn], x1 = kColumns_m[kPitColumn + 1];
    const double z0 = kRows_m[kPitRow], z1 = kRows_m[kPitRow + 1], y = -kPitDepth_m;
    mesh.quad({x0, y, z0}, {x1, y, z0}, {x1, 0, z0}, {x0, 0, z0});
    mesh.quad({x1, y, z1}, {x0, y, z1}, {x0, 0, z1}, {x1, 0, z1});
    mesh.quad({x0, y, z1}, {x0, y, z0}, {x0, 0, z0}, {x0, 0, z1});
    mesh.quad({x1, y, z0}, {x1, y, z1}, {x1, 0, z1}, {x1, 0, z0});
    return mesh;
}

MeshBuilder box(const dvec3& low, const dvec3& high) {
    MeshBuilder mesh;
    add_box(mesh, low, high);
    return mesh;
}

}  // namespace

Scene generate_yard() {
    SceneBuilder scene;
    const int stone = scene.material("stone", glm::vec3(0.7f));
    scene.place(scene.mesh(floor_with_pit(), stone));
    scene.place(scene.mesh(box({-5, -0.05, -3.3}, {2, 2, -3}), stone));     // the wall
    scene.place(scene.mesh(box({-2, -0.05, -1.5}, {-1, 1, -0.5}), stone));  // the box
    MeshBuilder ball;
    add_sphere(ball, dvec3(0.6, 0.8, -1.5), 0.5, 4);
    scene.place(scene.mesh(ball, stone));
    return scene.take();
}

}  // namespace aoscore::builtin
