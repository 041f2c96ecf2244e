#include "scene/view_file.h"

#include "core/error.h"
#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <numbers>

namespace {

namespace fs = std::filesystem;
using aoscore::Error;
using aoscore::Scene;
using aoscore::ViewFile;
using aoscore::testing::GltfFile;
using nlohmann::json;

/// A project folder of its own, with a scene "room" and a view file for it.
class ViewFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = aoscore::testing::output_dir();
        setenv("AOSCORE_DATA", folder_.c_str(), 1);
        views_ = {{"title", "A room"},
                  {"verified", true},
                  {"bounds", {{"low", {0, 0, 0}}, {"high", {4, 2, 3}}, {"tolerance_m", 0.01}}},
                  {"views",
                   {{{"id", "wide"},
                     {"position", {2, 1, 2.5}},
                     {"target", {2, 1, 0}},
                     {"fovy_deg", 60},
                     {"near_m", 0.1},
                     {"far_m", 9},
                     {"radius_m", 0.5}},
                    {{"id", "plan"},
                     {"position", {2, 9, 1}},
                     {"target", {2, 0, 1}},
                     {"up", {0, 0, -1}},
                     {"half_height_m", 2},
                     {"near_m", 0.1},
                     {"far_m", 10}}}}};
    }
    void TearDown() override { unsetenv("AOSCORE_DATA"); }

    void write() {
        fs::create_directories(folder_ / "scenes" / "room");
        std::ofstream(folder_ / "scenes" / "room" / "views.json") << views_.dump(1);
    }
    ViewFile read() {
        write();
        return aoscore::read_view_file(aoscore::view_file_path("room"));
    }
    std::string refusal() {
        try {
            read();
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit_code(), aoscore::ExitCode::file_error);
            return error.what();
        }
    }
    Scene load_room(bool with_camera) {
        write();
        GltfFile file;
        file.add_box({0, 0, 0}, {4, 2, 3});
        file.add_node({{"mesh", 0}});
        if (with_camera) {
            file.document["cameras"] = {
                {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
            file.add_node({{"camera", 0}, {"name", "wide"}, {"translation", {2, 1, 9}}});
        }
        return aoscore::load_scene(file.write(folder_, "room").string());
    }

    fs::path folder_;
    json views_;
};

TEST_F(ViewFiles, GiveCamerasInTheirUnits) {
    const ViewFile file = read();
    ASSERT_EQ(file.views.size(), 2u);
    EXPECT_EQ(file.views[0].id, "wide");
    EXPECT_NEAR(file.views[0].camera.fovy_rad, std::numbers::pi / 3, 1e-12);
    EXPECT_EQ(file.views[0].camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(file.views[0].radius_m, 0.5);
    EXPECT_EQ(file.views[0].source, "scenes/room/views.json");
    EXPECT_EQ(file.views[0].note, "");
    EXPECT_EQ(file.views[1].camera.projection, aoscore::Camera::Projection::orthographic);
    EXPECT_EQ(file.views[1].camera.half_height, 2);
    EXPECT_FALSE(file.views[1].radius_m.has_value());
}

TEST_F(ViewFiles, ComeBeforeTheFilesOwnCamerasUnderUniqueIds) {
    const Scene scene = load_room(true);
    ASSERT_EQ(scene.views.size(), 3u);
    EXPECT_EQ(scene.views[0].source, "scenes/room/views.json");
    EXPECT_EQ(scene.views[2].id, "wide_2");
    EXPECT_EQ(scene.views[2].source, "camera node wide");
    EXPECT_EQ(&aoscore::find_view(scene, "plan"), &scene.views[1]);
    try {
        aoscore::find_view(scene, "wie");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), aoscore::ExitCode::usage);
        EXPECT_EQ(error.valid(), "wide, plan, wide_2");
    }
}

TEST_F(ViewFiles, ForAnotherSceneAreLeftOutWithAWarningOfBothBoxes) {
    views_["bounds"]["high"] = {4, 2, 3.5};
    const Scene scene = load_room(false);
    EXPECT_TRUE(scene.views.empty());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("3.500"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[0].find("3.000"), std::string::npos) << scene.warnings[0];
}

TEST_F(ViewFiles, ThatNobodyVerifiedSaySo) {
    views_["verified"] = false;
    views_["note"] = "made from the published bounds";
    EXPECT_EQ(read().views[0].note, "unverified: made from the published bounds");
}

TEST_F(ViewFiles, AreReadStrictly) {
    const json good = views_;
    const auto spoiled = [&](auto&& spoil) {
        views_ = good;
        spoil(views_);
        return refusal();
    };
    EXPECT_NE(spoiled([](json& j) { j["wiew"] = 1; }).find("wiew"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][1]["fov"] = 1; }).find("views[1].fov"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["bounds"]["colour"] = 1; }).find("bounds.colour"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0]["half_height_m"] = 1; }).find("views[0]"),
              std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0].erase("fovy_deg"); }).find("views[0]"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0]["target"] = j["views"][0]["position"]; }).find("views[0]"),
              std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][1].erase("up"); }).find("views[1]"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0]["far_m"] = 0.01; }).find("far_m"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0]["near_m"] = 0; }).find("near_m"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][0]["fovy_deg"] = 200; }).find("fovy_deg"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"][1]["id"] = "wide"; }).find("twice"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j["views"] = json::array(); }).find("views"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j.erase("verified"); }).find("verified"), std::string::npos);
    EXPECT_NE(spoiled([](json& j) { j.erase("bounds"); }).find("bounds"), std::string::npos);
}

TEST_F(ViewFiles, DoNotChangeTheDigest) {
    const std::string with_views = load_room(false).digest;
    views_["views"][0]["fovy_deg"] = 30;
    EXPECT_EQ(load_room(true).digest, with_views);
}

TEST(ShippedViewFiles, AreSound) {
    const fs::path scenes = aoscore::testing::source_dir() / "scenes";
    for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
        if (entry.path().filename() != "views.json") continue;
        EXPECT_NO_THROW({ EXPECT_FALSE(aoscore::read_view_file(entry.path()).title.empty()); })
            << entry.path();
    }
}

}  // namespace
