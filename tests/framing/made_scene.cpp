#include "made_scene.h"

#include "scene/scene_bounds.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace aoscore::testing {

MadeScene::MadeScene() = default;

MadeScene& MadeScene::triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    corners_.insert(corners_.end(), {a, b, c});
    return *this;
}

void MadeScene::quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    triangle(a, b, c).triangle(a, c, d);
}

MadeScene& MadeScene::box(const glm::dvec3& low, const glm::dvec3& high, bool inwards) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool far : {false, true}) {
            glm::dvec3 across(0), up(0), corner = low;
            across[(axis + 1) % 3] = (high - low)[(axis + 1) % 3];
            up[(axis + 2) % 3] = (high - low)[(axis + 2) % 3];
            if (far) corner[axis] = high[axis];
            // The product across x up points along +axis, which is outwards at the far side.
            if (far == inwards) std::swap(across, up);
            quad(corner, corner + across, corner + across + up, corner + up);
        }
    }
    return *this;
}

MadeScene& MadeScene::ball(const glm::dvec3& centre, double radius) {
    constexpr int kAround = 40, kDown = 20;
    const auto at = [&](int i, int j) {
        const double phi = 2 * std::numbers::pi * i / kAround, theta = std::numbers::pi * j / kDown;
        return centre + radius * glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                            std::sin(theta) * std::cos(phi));
    };
    for (int i = 0; i < kAround; ++i) {
        for (int j = 0; j < kDown; ++j) quad(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
    return *this;
}

Scene MadeScene::made(double scale) const {
    Scene scene;
    scene.id = "made";
    scene.materials.emplace_back();
    Mesh mesh;
    for (const glm::dvec3& corner : corners_) mesh.positions.emplace_back(corner);
    for (unsigned i = 0; i < corners_.size(); i += 3) mesh.triangles.emplace_back(i, i + 1, i + 2);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    scene.instances.back().scene_from_mesh = glm::dmat4(glm::dmat3(scale));
    measure_scene(scene, scene.id);
    return scene;
}

}  // namespace aoscore::testing
