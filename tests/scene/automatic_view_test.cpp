#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

namespace {

using aoscore::CameraFrame;
using aoscore::Scene;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;

Scene load_boxes(const std::vector<std::pair<glm::vec3, glm::vec3>>& boxes) {
    GltfFile file;
    for (const auto& [low, high] : boxes) file.add_node({{"mesh", file.add_box(low, high)}});
    return file.load(output_dir());
}

TEST(AutomaticView, OfAnObjectShowsAllOfItFromOutside) {
    // A box of tiny size, a large one, and one on a plate.
    for (const float size : {1e-3f, 1.0f, 500.0f}) {
        GltfFile file;
        file.add_node({{"mesh", file.add_box(glm::vec3(0), glm::vec3(size, size * 0.2f, size))}});
        file.add_node({{"mesh", file.add_box(glm::vec3(0.4f * size, 0.3f * size, 0.4f * size),
                                             glm::vec3(0.6f * size))}});
        const Scene scene = file.load(output_dir());
        ASSERT_EQ(scene.views.size(), 1u);
        EXPECT_EQ(scene.views[0].id, "auto");
        EXPECT_EQ(scene.views[0].source, "automatic");
        const CameraFrame frame(scene.views[0].camera, 100, 100);
        for (const glm::dvec3& p : aoscore::testing::all_corners(scene)) {
            const auto image = frame.project(glm::dvec3(frame.view_from_world() * glm::dvec4(p, 1)));
            EXPECT_TRUE(image.x >= 0 && image.x <= 100 && image.y >= 0 && image.y <= 100)
                << image.x << " " << image.y;
            EXPECT_GE(image.z, scene.views[0].camera.near);
            EXPECT_LE(image.z, scene.views[0].camera.far);
        }
    }
}

TEST(AutomaticView, OfARoomLooksAlongItFromInside) {
    // A hall long in z whose walls face inwards, with a block in the middle of its south half.
    const Scene scene = load_boxes({{{0, 0, 20}, {6, 4, 0}}, {{2, 0, 13}, {4, 3, 15}}});
    const aoscore::Camera& camera = scene.views[0].camera;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(camera.position[axis], scene.bounds.low[axis]);
        EXPECT_LT(camera.position[axis], scene.bounds.high[axis]);
    }
    EXPECT_NEAR(std::abs(camera.target.z - camera.position.z), 1, 1e-9);
    EXPECT_LT(camera.near, 0.1);
}

TEST(AutomaticView, IsTheSameEveryTime) {
    const auto first = load_boxes({{{0, 0, 0}, {6, 4, 20}}}).views[0].camera;
    const auto second = load_boxes({{{0, 0, 0}, {6, 4, 20}}}).views[0].camera;
    EXPECT_EQ(first.position, second.position);
    EXPECT_EQ(first.target, second.target);
}

}  // namespace
