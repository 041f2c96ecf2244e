#include "scene/builtin/generators.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace aoscore::builtin {
namespace {

/// Distance from the back wall to the pillars' axes, and between pillars, metres.
constexpr double kPillarZ_m = 3.5;
constexpr double kPillarSpacing_m = 3;

MeshBuilder pillar() {
    MeshBuilder mesh;
    add_bevelled_box(mesh, {-0.42, -0.05, -0.42}, {0.42, 0.3, 0.42}, 0.03);
    add_bevelled_box(mesh, {-0.35, 0.25, -0.35}, {0.35, 3.3, 0.35}, 0.03);
    add_bevelled_box(mesh, {-0.42, 3.2, -0.42}, {0.42, 3.55, 0.42}, 0.03);
    return mesh;
}

}  // namespace

/// The failure case of horizon-based ambient occlusion in Vermeer, Stochastic-Depth Ambient Occlusion, 2020,
/// section 4.5: against the back wall stand crates that darken wall and floor. From the view `main` the
/// middle one lies exactly behind a pillar, which itself is farther than the radius: no depth layer in front
/// holds the occluder. Crates are what moves here.
Scene generate_pillar() {
    SceneBuilder scene;
    const int plaster = scene.material("plaster", glm::vec3(0.75f, 0.72f, 0.66f));
    const int stone = scene.material("stone", glm::vec3(0.55f));
    const int wood = scene.material("wood", glm::vec3(0.45f, 0.3f, 0.18f));

    MeshBuilder room;
    add_box(room, {-8, -0.3, -0.3}, {8, 0, 12});
    add_box(room, {-8.2, -0.4, -0.4}, {8.2, 3.8, 0});
    add_box(room, {-8, 3.5, -0.3}, {8, 3.7, 4.2});
    scene.place(scene.mesh(room, plaster));

    const int pillars = scene.mesh(pillar(), stone);
    for (const int i : {-1, 0, 1}) scene.place(pillars, translation(kPillarSpacing_m * i, 0, kPillarZ_m));

    MeshBuilder stack;
    add_crates(stack, 3);
    const int crates = scene.mesh(stack, wood);
    for (const int i : {-1, 0, 1}) scene.place_dynamic(crates, translation(kPillarSpacing_m * i, 0, 0));
    return scene.take();
}

}  // namespace aoscore::builtin
