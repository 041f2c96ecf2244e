#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using aoscore::Camera;
using aoscore::Scene;
using aoscore::View;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;
using nlohmann::json;

/// A box of 2 m around the origin, and a perspective camera on this node.
GltfFile camera_file(json node, const json& lens = {{"yfov", 0.8}, {"znear", 0.1}}) {
    GltfFile file;
    file.add_box({-1, -1, -1}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", lens}}};
    node["camera"] = 0;
    file.add_node(node);
    return file;
}

TEST(GltfCameras, LookAlongTheirNodesMinusZ) {
    const double h = std::sqrt(0.5);
    GltfFile file =
        camera_file({{"name", "cam east"}, {"translation", {5, 2, 0}}, {"rotation", {0, h, 0, h}}});
    const Scene scene = file.load(output_dir());
    ASSERT_EQ(scene.views.size(), 1u);
    const View& view = scene.views[0];
    EXPECT_EQ(view.id, "cam_east");
    EXPECT_EQ(view.source, "camera node cam east");
    EXPECT_LT(glm::distance(view.camera.position, {5, 2, 0}), 1e-12);
    EXPECT_LT(glm::distance(view.camera.target - view.camera.position, {-1, 0, 0}), 1e-12);
    EXPECT_LT(glm::distance(view.camera.up, {0, 1, 0}), 1e-12);
    EXPECT_DOUBLE_EQ(view.camera.fovy_rad, 0.8);
}

TEST(GltfCameras, AreThereInScenesOfAnySize) {
    for (const float size : {1e-4F, 1e4F}) {
        GltfFile file;
        file.add_box({-size, -size, -size}, {size, size, size});
        file.add_node({{"mesh", 0}});
        file.document["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", size}}}}};
        file.add_node({{"camera", 0}, {"translation", {0, 0, 5 * size}}});
        const Scene scene = file.load(output_dir());
        ASSERT_EQ(scene.views.size(), 1u) << size;
        const glm::dvec3 sight = scene.views[0].camera.target - scene.views[0].camera.position;
        EXPECT_LT(glm::distance(glm::normalize(sight), {0, 0, -1}), 1e-9);
    }
}

TEST(GltfCameras, SeeASceneThatWasMadeSmallerThanTheirNearPlanes) {
    GltfFile file = camera_file({{"translation", {0, 0, 5}}});
    file.document["nodes"].push_back({{"scale", {0.001, 0.001, 0.001}}, {"children", {0, 1}}});
    file.document["scenes"][0]["nodes"] = {2};
    const Scene scene = file.load(output_dir());
    EXPECT_LT(scene.views[0].camera.near, 0.004);
    EXPECT_GT(scene.views[0].camera.far, 0.006);
    EXPECT_TRUE(aoscore::testing::has_warning(scene, "lies beyond all of the scene"));
}

TEST(GltfCameras, ScaleOfTheNodeDoesNotTouchTheView) {
    const auto folder = output_dir();
    GltfFile plain = camera_file({{"translation", {0, 0, 5}}});
    GltfFile scaled = camera_file({{"translation", {0, 0, 5}}, {"scale", {100, 3, 0.01}}});
    const Camera a = plain.load(folder).views[0].camera, b = scaled.load(folder).views[0].camera;
    EXPECT_EQ(a.position, b.position);
    EXPECT_LT(glm::distance(a.target, b.target), 1e-12);
    EXPECT_LT(glm::distance(a.up, b.up), 1e-12);
    EXPECT_EQ(a.near, b.near);
    EXPECT_EQ(a.far, b.far);
}

TEST(GltfCameras, AMirroredSceneGivesTheMirroredPicture) {
    const auto folder = output_dir();
    GltfFile file = camera_file({{"translation", {3, 2, 6}}, {"rotation", {0, 0.2, 0, std::sqrt(1 - 0.04)}}});
    const Scene scene = file.load(folder);
    // Puts the same under a root that mirrors x.
    file.document["nodes"].push_back({{"scale", {-1, 1, 1}}, {"children", {0, 1}}});
    file.document["scenes"][0]["nodes"] = {2};
    const Scene mirrored = file.load(folder);
    const aoscore::CameraFrame frame(scene.views[0].camera, 100, 80);
    const aoscore::CameraFrame mirrored_frame(mirrored.views[0].camera, 100, 80);
    const auto points = aoscore::testing::all_corners(scene);
    for (const glm::dvec3& p : points) {
        const glm::dvec3 twin(-p.x, p.y, p.z);
        const auto here = frame.project(glm::dvec3(frame.view_from_world() * glm::dvec4(p, 1)));
        const auto there =
            mirrored_frame.project(glm::dvec3(mirrored_frame.view_from_world() * glm::dvec4(twin, 1)));
        EXPECT_NEAR(there.x, 100 - here.x, 1e-9);
        EXPECT_NEAR(there.y, here.y, 1e-9);
        EXPECT_NEAR(there.z, here.z, 1e-9);
    }
}

TEST(GltfCameras, FarReachesWhatTheSceneNeedsAndNoFurther) {
    const auto folder = output_dir();
    for (const json& lens :
         {json{{"yfov", 0.8}, {"znear", 0.1}}, json{{"yfov", 0.8}, {"znear", 0.1}, {"zfar", 1e30}}}) {
        const Camera camera = camera_file({{"translation", {0, 0, 5}}}, lens).load(folder).views[0].camera;
        EXPECT_GE(camera.far, 6.0);
        EXPECT_LE(camera.far, 6.4);
        EXPECT_EQ(camera.near, 0.1);
    }
    const json near_lens = {{"yfov", 0.8}, {"znear", 0.1}, {"zfar", 4.5}};
    EXPECT_EQ(camera_file({{"translation", {0, 0, 5}}}, near_lens).load(folder).views[0].camera.far, 4.5);
}

TEST(GltfCameras, ANearPlaneThatWouldCostTheDepthItsPrecisionIsRaised) {
    const Scene scene =
        camera_file({{"translation", {0, 0, 5}}}, {{"yfov", 0.8}, {"znear", 1e-9}}).load(output_dir());
    EXPECT_GE(scene.views[0].camera.near, 5e-5);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("znear"), std::string::npos);
}

TEST(GltfCameras, ACameraThatLooksAwayStillHasAPicture) {
    const Scene scene = camera_file({{"translation", {0, 0, -50}}}).load(output_dir());
    EXPECT_NO_THROW(aoscore::CameraFrame(scene.views[0].camera, 8, 8));
}

TEST(GltfCameras, OrthographicOnesKeepTheirHeight) {
    GltfFile file = camera_file({{"translation", {0, 0, 5}}});
    file.document["cameras"] = {
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 9}, {"ymag", 2.5}, {"znear", 0}, {"zfar", 100}}}}};
    const Camera camera = file.load(output_dir()).views[0].camera;
    EXPECT_EQ(camera.projection, Camera::Projection::orthographic);
    EXPECT_EQ(camera.half_height, 2.5);
    EXPECT_GT(camera.near, 0);
    EXPECT_LT(camera.near, 1e-3);
    EXPECT_NEAR(camera.far, 6.2, 0.2);
}

TEST(GltfCameras, IdsAreUnique) {
    GltfFile file = camera_file({{"name", "cam"}});
    file.add_node({{"name", "cam"}, {"camera", 0}, {"translation", {1, 0, 0}}});
    file.add_node({{"camera", 0}, {"translation", {2, 0, 0}}});
    std::set<std::string> ids;
    for (const View& view : file.load(output_dir()).views) ids.insert(view.id);
    EXPECT_EQ(ids, (std::set<std::string>{"cam", "cam_2", "camera"}));
}

}  // namespace
