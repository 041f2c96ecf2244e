#include "gltf_file.h"
#include "scene/scene.h"
#include "scene/scene_bounds.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using aoscore::Bounds;
using aoscore::Scene;
using aoscore::testing::all_corners;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;

TEST(Origin, OrdinaryScenesKeepTheirs) {
    GltfFile file;
    file.add_box({100, 0, 5}, {140, 20, 30});
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.origin, glm::dvec3(0.0));
    EXPECT_EQ(scene.bounds.low, glm::dvec3(100, 0, 5));
}

TEST(Origin, FarScenesMoveIntoReachOfFloatsWithoutLosingAMillimetre) {
    GltfFile file;
    file.add_box({0, 0, 0}, {4, 2, 3});
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    file.add_node({{"mesh", 0}, {"translation", {4000000.125, -70000.25, 3}}});
    file.add_node({{"camera", 0}, {"translation", {4000002.125, -69999.25, 9}}});
    const Scene scene = file.load(output_dir());
    EXPECT_LT(glm::length(scene.bounds.centre()), 10);
    EXPECT_EQ(scene.origin + scene.bounds.low, glm::dvec3(4000000.125, -70000.25, 3));
    EXPECT_EQ(scene.origin + scene.views[0].camera.position, glm::dvec3(4000002.125, -69999.25, 9));
    EXPECT_NEAR(scene.views[0].camera.far, 6.2, 0.2);
}

TEST(Origin, PositionsBakedFarOffAreRecentredExactly) {
    GltfFile file;
    file.add_box({1e6f, -2e6f, 0}, {1e6f + 4, -2e6f + 2, 3});
    file.add_node({{"mesh", 0}, {"translation", {-1e6, 2e6, 0}}});
    const Scene scene = file.load(output_dir());
    // The node brings the mesh back: the scene is where it was, and its floats are small.
    EXPECT_EQ(scene.origin, glm::dvec3(0.0));
    EXPECT_EQ(scene.bounds.low, glm::dvec3(0.0));
    EXPECT_EQ(scene.bounds.high, glm::dvec3(4, 2, 3));
    for (const glm::vec3& p : scene.meshes[0].positions) EXPECT_LT(glm::length(p), 10);
}

TEST(Origin, IsAMultipleOfAPowerOfTwoOfTheScenesSize) {
    for (const double diagonal : {1e-4, 0.3, 12.0, 5e4}) {
        const glm::dvec3 centre(7e8 * diagonal, -3.3e7 * diagonal, 0.1 * diagonal);
        const Bounds bounds{centre - diagonal / 4, centre + diagonal / 4};
        const glm::dvec3 origin = aoscore::suitable_origin(bounds);
        EXPECT_LT(glm::distance(origin, centre), 2 * diagonal);
        const double unit = std::exp2(std::floor(std::log2(bounds.diagonal())));
        EXPECT_EQ(origin / unit, glm::round(origin / unit));
    }
}

TEST(Origin, TinyScenesKeepTheirDetails) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1e-4f, 2e-4f, 3e-4f});
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.triangle_count, 12u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Origin, ScenesThatLeaveFloatRangeAreRefused) {
    GltfFile wide;
    wide.add_box({0, 0, 0}, {1, 1, 1});
    wide.add_node({{"mesh", 0}, {"scale", {1e12, 1, 1}}});
    EXPECT_NE(wide.refusal(output_dir()).find("m wide"), std::string::npos);
}

}  // namespace
