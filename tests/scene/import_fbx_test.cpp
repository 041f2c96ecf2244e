#include "gltf_file.h"
#include "import_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using aoscore::LoadOptions;
using aoscore::Scene;
using aoscore::testing::area_of;
using aoscore::testing::ImportFolder;
using aoscore::testing::warnings_of;
using ::testing::HasSubstr;

/// A text FBX 7.4: one quad of 1 x 2 in x and y, placed by two nodes, the second 10 further along x.
std::string fbx(double unit_in_cm, bool z_up, const std::string& material = "",
                const std::string& of_first = "") {
    const auto axis = [](const char* name, int value) {
        return fmt::format("    P: \"{}\", \"int\", \"Integer\", \"\",{}\n", name, value);
    };
    const auto node = [](int id, double x, const std::string& more = "") {
        return fmt::format(
            "  Model: {}, \"Model::quad{}\", \"Mesh\" {{\n   Version: 232\n   Properties70: {{\n"
            "    P: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\",{},0,0\n{}   }}\n  }}\n",
            id, id, x, more);
    };
    return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
           "GlobalSettings: {\n Version: 1000\n Properties70: {\n" +
           axis("UpAxis", z_up ? 2 : 1) + axis("UpAxisSign", 1) + axis("FrontAxis", z_up ? 1 : 2) +
           axis("FrontAxisSign", z_up ? -1 : 1) + axis("CoordAxis", 0) + axis("CoordAxisSign", 1) +
           fmt::format("    P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",{}\n }}\n}}\n", unit_in_cm) +
           "Objects: {\n  Geometry: 1, \"Geometry::quad\", \"Mesh\" {\n   Vertices: *12 {\n    a: "
           "0,0,0,1,0,0,1,2,0,0,2,0\n   }\n"
           "   PolygonVertexIndex: *4 {\n    a: 0,1,2,-4\n   }\n   GeometryVersion: 124\n  }\n" +
           node(2, 0, of_first) + node(3, 10) + material +
           "}\nConnections: {\n  C: \"OO\",1,2\n  C: \"OO\",1,3\n  C: \"OO\",2,0\n  C: \"OO\",3,0\n" +
           (material.empty() ? "" : "  C: \"OO\",4,2\n  C: \"OO\",4,3\n") + "}\n";
}

TEST(Fbx, PlacesOneMeshManyTimesInItsOwnUnit) {
    const ImportFolder folder;
    for (const double unit_in_cm : {1.0, 100.0, 2.54}) {
        const Scene scene = folder.load("a.fbx", fbx(unit_in_cm, false));
        EXPECT_EQ(scene.meshes.size(), 1u);
        EXPECT_EQ(scene.instances.size(), 2u);
        const double metres = unit_in_cm / 100;
        EXPECT_NEAR(area_of(scene), 4 * metres * metres, 1e-5 * metres);
        EXPECT_NEAR(scene.bounds.high.x, 11 * metres, 1e-5 * metres);
        EXPECT_NEAR(scene.bounds.high.y, 2 * metres, 1e-5 * metres);
    }
}

TEST(Fbx, ItsUpAxisBecomesY) {
    const ImportFolder folder;
    const Scene scene = folder.load("a.fbx", fbx(100, true));
    // The y axis of a file with z up points away from the viewer.
    EXPECT_NEAR(scene.bounds.low.z, -2, 1e-6);
    EXPECT_NEAR(scene.bounds.high.y, 0, 1e-6);
    EXPECT_NEAR(scene.bounds.high.x, 11, 1e-6);
}

TEST(Fbx, UnitAndAxisOfTheCommandLineGoBeforeItsOwn) {
    const ImportFolder folder;
    LoadOptions options;
    options.metres_per_unit = 2;
    options.up = aoscore::UpAxis::y;
    const Scene scene = folder.load("a.fbx", fbx(100, true), options);
    EXPECT_NEAR(scene.bounds.high.x, 22, 1e-6);
    EXPECT_NEAR(scene.bounds.high.y, 4, 1e-6);
}

TEST(Fbx, HiddenNodesAreDrawnAndSaid) {
    const ImportFolder folder;
    const auto warnings = [&](const std::string& property) {
        const Scene scene = folder.load("a.fbx", fbx(100, false, "", property));
        EXPECT_EQ(scene.instances.size(), 2u);
        return warnings_of(scene);
    };
    EXPECT_THAT(warnings("    P: \"Show\", \"bool\", \"\", \"\",0\n"), HasSubstr("1 nodes are hidden"));
    EXPECT_THAT(warnings("    P: \"Visibility\", \"Visibility\", \"\", \"A\",0\n"),
                HasSubstr("1 nodes are hidden"));
    for (const char* shown : {"", "    P: \"Show\", \"bool\", \"\", \"\",1\n",
                              "    P: \"Visibility\", \"Visibility\", \"\", \"A\",0.5\n"}) {
        EXPECT_EQ(warnings(shown).find("hidden"), std::string::npos) << shown;
    }
}

TEST(Fbx, WhatIsBrokenIsRefused) {
    const ImportFolder folder;
    const std::string whole = fbx(1, false);
    for (const std::string& content :
         {std::string(), std::string("Kaydara FBX Binary  \0\x1a\0", 23), whole.substr(0, whole.size() / 2),
          std::string("; FBX 7.4.0 project file\n") + std::string(100000, '{')}) {
        EXPECT_NE(folder.refusal("bad.fbx", content), "") << content.substr(0, 80);
    }
}

}  // namespace
