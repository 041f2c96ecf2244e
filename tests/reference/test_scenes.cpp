#include "reference/test_scenes.h"

#include "core/sampling.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace aoscore::testing {

Scene empty_scene() {
    Scene scene;
    scene.id = "test";
    scene.materials.emplace_back();
    return scene;
}

void add(Scene& scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, glm::dmat4(1.0)});
}

Mesh quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    Mesh mesh;
    mesh.positions = {glm::vec3(a), glm::vec3(b), glm::vec3(c), glm::vec3(d)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Mesh floor_grid(double half_size, int cells) {
    Mesh mesh;
    const auto row = static_cast<unsigned>(cells + 1);
    for (int z = 0; z <= cells; ++z) {
        for (int x = 0; x <= cells; ++x) {
            mesh.positions.emplace_back((2.0 * x / cells - 1) * half_size, 0,
                                        (2.0 * z / cells - 1) * half_size);
        }
    }
    for (unsigned z = 0; z + 1 < row; ++z) {
        for (unsigned x = 0; x + 1 < row; ++x) {
            const unsigned i = z * row + x;
            mesh.triangles.push_back({i, i + row, i + 1});
            mesh.triangles.push_back({i + 1, i + row, i + row + 1});
        }
    }
    return mesh;
}

Mesh sphere(const glm::dvec3& centre, double radius, int n) {
    Mesh mesh;
    const auto row = static_cast<unsigned>(2 * n + 1);
    for (int j = 0; j <= n; ++j) {
        const double theta = std::numbers::pi * j / n;
        for (int i = 0; i <= 2 * n; ++i) {
            const double phi = std::numbers::pi * i / n;
            mesh.positions.emplace_back(centre + radius * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                                     std::cos(theta),
                                                                     std::sin(theta) * std::sin(phi)));
        }
    }
    for (unsigned j = 0; j < static_cast<unsigned>(n); ++j) {
        for (unsigned i = 0; i + 1 < row; ++i) {
            const unsigned k = j * row + i;
            mesh.triangles.push_back({k, k + 1, k + row});
            mesh.triangles.push_back({k + 1, k + row + 1, k + row});
        }
    }
    return mesh;
}

Scene still_life() {
    Scene scene = empty_scene();
    add(scene, floor_grid(4, 3));
    add(scene, sphere({0, 0.5, 0}, 0.5, 24));
    add(scene, sphere({0.9, 0.25, 0.3}, 0.25, 16));
    add(scene, quad({-1, 0, -1}, {1, 0, -1.2}, {1, 1.5, -1.2}, {-1, 1.5, -1}));
    return scene;
}

Scene thicket() {
    Scene scene = empty_scene();
    add(scene, floor_grid(4, 3));
    Mesh blades;
    auto random = [state = std::uint64_t{1}]() mutable {
        return static_cast<double>(mix_bits(state++) >> 11) * 0x1p-53 * 2 - 1;
    };
    for (unsigned i = 0; i < 300; ++i) {
        const glm::dvec3 root(1.5 * random(), 0, 1.5 * random());
        const glm::dvec3 tip = root + glm::dvec3(0.5 * random(), 0.7 + 0.5 * random(), 0.5 * random());
        const glm::dvec3 width(0.02 * random(), 0, 0.02 * random());
        for (const glm::dvec3& p : {root - width, root + width, tip}) blades.positions.emplace_back(p);
        blades.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    add(scene, std::move(blades));
    return scene;
}

glm::dmat4 Similarity::matrix() const {
    return glm::scale(glm::translate(glm::dmat4(1), translation), glm::dvec3(scale)) *
           glm::rotate(glm::dmat4(1), angle_rad, axis);
}

Scene moved(Scene scene, const Similarity& by) {
    for (Instance& instance : scene.instances)
        instance.scene_from_mesh = by.matrix() * instance.scene_from_mesh;
    return scene;
}

Camera moved(Camera camera, const Similarity& by) {
    camera.position = glm::dvec3(by.matrix() * glm::dvec4(camera.position, 1));
    camera.target = glm::dvec3(by.matrix() * glm::dvec4(camera.target, 1));
    camera.up = glm::dmat3(by.matrix()) * camera.up;
    camera.half_height *= by.scale;
    camera.near *= by.scale;
    camera.far *= by.scale;
    return camera;
}

Camera looking(const glm::dvec3& position, const glm::dvec3& target, double fovy_rad) {
    Camera camera;
    camera.position = position;
    camera.target = target;
    camera.up =
        std::abs(glm::normalize(target - position).y) > 0.99 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    camera.fovy_rad = fovy_rad;
    camera.near = 0.01;
    camera.far = 1000;
    return camera;
}

}  // namespace aoscore::testing
