#include "scene/scene_frame.h"

#include "gltf_file.h"
#include "import_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using aoscore::Bounds;
using aoscore::LoadOptions;
using aoscore::Scene;
using aoscore::UpAxis;
using aoscore::ViewFile;
using aoscore::testing::ImportFolder;
using aoscore::testing::warnings_of;
using ::testing::HasSubstr;

ViewFile hall(double tolerance = 0.05) {
    ViewFile views;
    views.bounds = {{-19.2, -1.3, -11.8}, {18, 14.3, 11.1}};
    views.tolerance_m = tolerance;
    return views;
}

Bounds scaled(const Bounds& bounds, double factor) {
    return {bounds.low * factor, bounds.high * factor};
}

TEST(SceneFrame, OfAViewFilesOwnSceneIsFoundInAnyUnit) {
    for (const double unit : {1.0, 0.01, 0.001, 0.0254, 0.3048, 1000.0}) {
        Bounds bounds = scaled(hall().bounds, 1 / unit);
        bounds.high.x += 0.02 / unit;
        const auto frame = recognise(hall(), bounds, true, true);
        ASSERT_TRUE(frame.has_value()) << unit;
        EXPECT_EQ(frame->metres_per_unit, unit);
        EXPECT_EQ(frame->y_up_from_file, glm::dmat3(1));
    }
}

TEST(SceneFrame, OfNoUnitIsAFactorWhereTheBoundsAreExact) {
    const auto frame = recognise(hall(), scaled(hall().bounds, 7), true, true);
    ASSERT_TRUE(frame.has_value());
    EXPECT_NEAR(frame->metres_per_unit, 1.0 / 7, 1e-12);
    EXPECT_FALSE(recognise(hall(4), scaled(hall().bounds, 7), true, true).has_value());
    EXPECT_FALSE(recognise(hall(), scaled(hall().bounds, 7), false, true).has_value());
}

TEST(SceneFrame, OfASceneWithZUpIsFoundByItsBox) {
    const Bounds y_up = hall().bounds;
    // y up from z up takes (x, y, z) to (x, z, -y).
    const Bounds z_up{{y_up.low.x, -y_up.high.z, y_up.low.y}, {y_up.high.x, -y_up.low.z, y_up.high.y}};
    const auto frame = recognise(hall(), scaled(z_up, 100), true, true);
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->metres_per_unit, 0.01);
    EXPECT_EQ(frame->y_up_from_file * glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0));
    EXPECT_DOUBLE_EQ(glm::determinant(frame->y_up_from_file), 1);
    EXPECT_FALSE(recognise(hall(), scaled(z_up, 100), true, false).has_value());
}

TEST(SceneFrame, OfAnotherSceneIsNone) {
    Bounds other = hall().bounds;
    other.high.y += 3;
    EXPECT_FALSE(recognise(hall(), other, true, true).has_value());
    EXPECT_FALSE(recognise(hall(), {glm::dvec3(0), glm::dvec3(0)}, true, true).has_value());
}

TEST(SceneFrame, OfTheCommandLineHoldsForEveryFormat) {
    const ImportFolder folder;
    LoadOptions options;
    options.metres_per_unit = 0.001;
    options.up = UpAxis::z;
    options.camera.emplace().position = {5, 5, 5};
    options.camera->target = {0, 1, 0};
    aoscore::testing::GltfFile gltf;
    gltf.add_box({0, 0, 0}, {1000, 2000, 3000});
    gltf.add_node({{"mesh", 0}});
    const std::string obj = "v 0 0 0\nv 1000 0 0\nv 1000 2000 0\nv 0 0 3000\nf 1 2 3\nf 1 2 4\n";
    for (const Scene& scene : {gltf.load(folder.path(), options), folder.load("a.obj", obj, options)}) {
        EXPECT_NEAR(glm::distance(scene.bounds.low, glm::dvec3(0, 0, -2)), 0, 1e-9);
        EXPECT_NEAR(glm::distance(scene.bounds.high, glm::dvec3(1, 3, 0)), 0, 1e-9);
        ASSERT_FALSE(scene.views.empty());
        EXPECT_THAT(scene.views[0].options, HasSubstr("--unit mm --up z"));
    }
}

TEST(SceneFrame, IsFoundByAViewFileBesideTheScene) {
    const ImportFolder folder;
    folder.write("a.views.json",
                 R"({"title": "Room", "verified": true,
                     "bounds": {"low": [0, 0, 0], "high": [4, 2, 3], "tolerance_m": 0.01},
                     "views": [{"id": "wide", "position": [2, 1, 9], "target": [2, 1, 0], "fovy_deg": 60, "near_m": 0.1,
                                "far_m": 50}]})");
    const std::string obj = "v 0 0 0\nv 400 0 0\nv 400 200 300\nf 1 2 3\n";
    const Scene scene = folder.load("a.obj", obj);
    EXPECT_NEAR(scene.bounds.high.x, 4, 1e-9);
    EXPECT_EQ(scene.views[0].id, "wide");
    EXPECT_THAT(warnings_of(scene), HasSubstr("a.views.json knows this scene at another scale"));
    EXPECT_THAT(warnings_of(scene), HasSubstr("times 0.01"));
    LoadOptions metres;
    metres.metres_per_unit = 1;
    EXPECT_NEAR(folder.load("a.obj", obj, metres).bounds.high.x, 400, 1e-9);
}

TEST(SceneFrame, ThatNobodyStatesIsMetresAndSaidSo) {
    const ImportFolder folder;
    const std::string obj = "v 0 0 0\nv 4 0 0\nv 4 2 3\nf 1 2 3\n";
    EXPECT_THAT(warnings_of(folder.load("a.obj", obj)), HasSubstr("OBJ states no unit"));
    LoadOptions metres;
    metres.metres_per_unit = 1;
    EXPECT_EQ(warnings_of(folder.load("a.obj", obj, metres)), "");
}

TEST(Units, HaveNamesAndNumbers) {
    EXPECT_EQ(aoscore::parse_unit("in"), 0.0254);
    EXPECT_EQ(aoscore::parse_unit("0.5"), 0.5);
    for (const char* text : {"", "yd", "0", "-1", "nan", "inf", "1e99", "1 cm"})
        EXPECT_FALSE(aoscore::parse_unit(text).has_value()) << text;
    EXPECT_EQ(aoscore::unit_text(0.01), "cm");
    EXPECT_EQ(aoscore::unit_text(0.5), "0.5");
}

}  // namespace
