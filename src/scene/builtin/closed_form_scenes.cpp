#include "scene/builtin/closed_forms.h"
#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

#include <cmath>
#include <numbers>

namespace aoscore::builtin {
namespace {

using glm::dvec3;

/// A square floor y = 0 in cells of about `cell_m`: huge triangles would cost both paths precision.
void add_floor(MeshBuilder& mesh, double half_size_m, double cell_m) {
    const int cells = static_cast<int>(std::ceil(2 * half_size_m / cell_m));
    add_surface(mesh, cells, cells, [&](double u, double v) {
        return dvec3((2 * u - 1) * half_size_m, 0, (1 - 2 * v) * half_size_m);
    });
}

Scene wall_of_height(double height_m) {
    namespace wall = closed_form::wall;
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.8f));
    MeshBuilder floor;
    add_floor(floor, wall::kFloorHalfSize_m, 10);
    scene.place(scene.mesh(floor, plaster));
    MeshBuilder masonry;
    constexpr int kBlocks = 30;
    // One outline in x,y, run along z in pieces; its foot stands in the floor.
    Profile outline{{0, -0.1}, {0, height_m}, {-wall::kThickness_m, height_m}, {-wall::kThickness_m, -0.1}};
    for (int i = 0; i < kBlocks; ++i) {
        const double length = 2 * wall::kHalfLength_m / kBlocks;
        add_run(masonry, outline, i * length - wall::kHalfLength_m, (i + 1) * length - wall::kHalfLength_m);
    }
    for (const double end : {-wall::kHalfLength_m, wall::kHalfLength_m}) {
        const dvec3 a(-wall::kThickness_m, -0.1, end), b(0, -0.1, end), c(0, height_m, end),
            d(-wall::kThickness_m, height_m, end);
        if (end > 0) {
            masonry.quad(a, b, c, d);
        } else {
            masonry.quad(b, a, d, c);
        }
    }
    scene.place(scene.mesh(masonry, plaster));
    return scene.take();
}

}  // namespace

Scene generate_plane() {
    namespace plane = closed_form::plane;
    SceneBuilder scene;
    MeshBuilder mesh;
    const dvec3 n = plane::normal();
    const dvec3 across = glm::normalize(glm::cross(n, dvec3(0, 0, 1)));
    const dvec3 along = glm::cross(n, across);
    add_surface(mesh, 16, 16, [&](double u, double v) {
        return plane::kHalfSize_m * ((2 * u - 1) * across + (2 * v - 1) * along);
    });
    scene.place(scene.mesh(mesh, scene.material("plane", glm::vec3(0.8f))));
    return scene.take();
}

Scene generate_wall() {
    return wall_of_height(closed_form::wall::kHeight_m);
}

Scene generate_wall_tall() {
    return wall_of_height(closed_form::wall::kTallHeight_m);
}

Scene generate_sphere() {
    namespace sphere = closed_form::sphere;
    SceneBuilder scene;
    const int white = scene.material("white", glm::vec3(0.8f));
    MeshBuilder floor;
    add_floor(floor, sphere::kFloorHalfSize_m, 5);
    scene.place(scene.mesh(floor, white));
    MeshBuilder ball;
    add_sphere(ball, dvec3(0, sphere::kCentreHeight_m, 0), sphere::kRadius_m, sphere::kLevels);
    scene.place(scene.mesh(ball, white));
    return scene.take();
}

Scene generate_pit() {
    namespace pit = closed_form::pit;
    SceneBuilder scene;
    MeshBuilder mesh;
    const double turn = 2 * std::numbers::pi / pit::kSegments;
    const double corner_radius = pit::kRadius_m * std::sqrt(turn / std::sin(turn));
    const double rim = pit::depth_m();
    Profile section;  // walked inwards and down: the visible side is above and inside
    for (const double radius : {pit::kGroundRadius_m, 10.0, 4.0, 2.0, 1.4}) section.emplace_back(radius, rim);
    for (int i = 0; i <= 8; ++i) section.emplace_back(corner_radius, rim * (1 - i / 8.0));
    for (int i = 7; i >= 0; --i) section.emplace_back(corner_radius * i / 8.0, 0);
    add_lathe(mesh, section, pit::kSegments);
    scene.place(scene.mesh(mesh, scene.material("ground", glm::vec3(0.8f))));
    return scene.take();
}

}  // namespace aoscore::builtin
