#include "stress/stress_triangles.h"

#include "stress/stress_case.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace aoscore::testing {
namespace {

double area(const Scene& scene) {
    double sum = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
            sum += glm::length(glm::cross(b - a, c - a)) / 2;
        }
    }
    return sum;
}

std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
    return count;
}

TEST(StressTriangles, CoverTheSameSurfacesHoweverTheyAreCut) {
    const Scene base = base_stress_case(64).scene;
    Scene split = base, needles = base, empty = base;
    split_to_edges(split, 0.3);
    split_to_needles(needles, 20, 1 << 17);
    add_triangles_without_area(empty);
    for (const Scene* scene : {&split, &needles, &empty}) {
        EXPECT_NEAR(area(*scene), area(base), 1e-5 * area(base));
        EXPECT_GT(triangles(*scene), triangles(base));
        for (const Mesh& mesh : scene->meshes) EXPECT_EQ(mesh.positions.size(), mesh.normals.size());
    }
    EXPECT_EQ(triangles(empty), 7 * triangles(base));
}

TEST(StressTriangles, AreNoLongerThanAsked) {
    Scene scene = base_stress_case(64).scene;
    split_to_edges(scene, 0.3);
    for (const Mesh& mesh : scene.meshes) {
        for (const glm::uvec3& t : mesh.triangles)
            ASSERT_LE(glm::distance(mesh.positions[t.x], mesh.positions[t.y]), 0.3F);
    }
}

TEST(StressTriangles, ComeTwiceWhereSurfacesDo) {
    const Scene base = base_stress_case(64).scene;
    Scene twice = base, apart = base;
    add_surfaces_again(twice, 0, false);
    add_surfaces_again(apart, 0.01, false);
    EXPECT_EQ(twice.instances.size(), 2 * base.instances.size());
    EXPECT_EQ(twice.meshes[base.meshes.size()].positions, base.meshes[0].positions);
    EXPECT_NEAR(static_cast<double>(glm::distance(apart.meshes[base.meshes.size()].positions[0],
                                                  base.meshes[0].positions[0])),
                0.01, 1e-6);
}

}  // namespace
}  // namespace aoscore::testing
