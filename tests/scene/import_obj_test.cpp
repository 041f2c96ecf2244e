#include "gltf_file.h"
#include "import_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace {

using aoscore::LoadOptions;
using aoscore::Scene;
using aoscore::testing::area_of;
using aoscore::testing::ImportFolder;
using aoscore::testing::warnings_of;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, PolygonsAreCoveredExactlyConvexOrNot) {
    const ImportFolder folder;
    // An arrowhead whose shorter diagonal lies outside it, an L, and a comb; areas by the shoelace formula.
    const struct {
        const char* vertices;
        int corners;
        double area;
    } cases[] = {{"v 0 0 0\nv 10 1 0\nv 0 2 0\nv 8 1 0\n", 4, 2.0},
                 {"v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n", 6, 3.0},
                 {"v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\n"
                  "v 1 3 0\nv 0 3 0\n",
                  12, 11.0}};
    for (const auto& c : cases) {
        std::string face = "f", reversed = "f";
        for (int i = 1; i <= c.corners; ++i) face += fmt::format(" {}", i);
        for (int i = c.corners; i >= 1; --i) reversed += fmt::format(" {}", i);
        EXPECT_NEAR(area_of(folder.load("a.obj", c.vertices + face + "\n")), c.area, 1e-6);
        EXPECT_NEAR(area_of(folder.load("a.obj", c.vertices + reversed + "\n")), c.area, 1e-6);
    }
}

TEST(Obj, StarsOfAnyShapeAndTiltKeepTheirAreaAndWinding) {
    const ImportFolder folder;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.1, 1.0), turn(0, 2 * std::numbers::pi);
    for (int trial = 0; trial < 12; ++trial) {
        const double tilt = turn(random), heading = turn(random);
        const int corners = 5 + 7 * trial;
        std::string text;
        double shoelace = 0;
        glm::dvec2 first(0), last(0);
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            const glm::dvec2 p = radius(random) * glm::dvec2(std::cos(angle), std::sin(angle));
            if (i > 0) shoelace += (last.x * p.y - last.y * p.x) / 2;
            if (i == 0) first = p;
            last = p;
            const double y = p.y * std::cos(tilt);
            text += fmt::format("v {} {} {}\n", p.x * std::cos(heading) - y * std::sin(heading),
                                p.x * std::sin(heading) + y * std::cos(heading), p.y * std::sin(tilt));
        }
        shoelace += (last.x * first.y - last.y * first.x) / 2;
        text += "f";
        for (int i = 1; i <= corners; ++i) text += fmt::format(" {}", i);
        const Scene scene = folder.load("star.obj", text + "\n");
        EXPECT_EQ(scene.triangle_count, static_cast<std::size_t>(corners - 2));
        EXPECT_NEAR(area_of(scene), shoelace, 1e-5);
        // No triangle is turned over: their areas as vectors have the same sum.
        glm::dvec3 sum(0);
        const auto points = aoscore::testing::all_corners(scene);
        for (std::size_t i = 0; i + 2 < points.size(); i += 3)
            sum += glm::cross(points[i + 1] - points[i], points[i + 2] - points[i]) / 2.0;
        EXPECT_NEAR(glm::length(sum), shoelace, 1e-5);
    }
}

TEST(Obj, IndicesCountFromTheStartOrBackFromHereAcrossContinuedLinesAndAnyLineEnd) {
    const ImportFolder folder;
    const Scene plain = folder.load("a.obj", kSquare + "f 1 2 3 4\n");
    EXPECT_EQ(plain.triangle_count, 2u);
    for (const std::string& text :
         {kSquare + "f -4 -3 -2 -1", kSquare + "f 1 2 \\\n 3 \\\n4\n",
          "\xEF\xBB\xBF# comment\n" + kSquare + "f 1 2 3 4 # square\n",
          std::string("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0 \r\nf 1 2\\\r\n 3 4\r\n"),
          "g a b\no c\ns off\nvt 0 0\nvn 0 0 1\n" + kSquare + "f 1//1 2//1 3//1 4//1\nl 1 2\np 1\n"}) {
        EXPECT_EQ(folder.load("b.obj", text).bounds.high, plain.bounds.high) << text;
        EXPECT_NEAR(area_of(folder.load("b.obj", text)), 1.0, 1e-9) << text;
    }
}

TEST(Obj, NormalsAreSmoothWhereGivenAndFlatElsewhere) {
    const ImportFolder folder;
    const Scene scene = folder.load("a.obj", kSquare + "vn 0 0.6 0.8\nf 1//1 2//1 3//1\nf 1 3 4\n");
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_TRUE(scene.meshes[0].normals.empty());
    ASSERT_EQ(scene.meshes[1].normals.size(), 3u);
    EXPECT_NEAR(scene.meshes[1].normals[0].y, 0.6f, 1e-6);
}

TEST(Obj, PlacesFarFromTheOriginKeepTheirDetails) {
    const ImportFolder folder;
    // National grids lie millions of metres off, where float32 has steps of half a metre.
    const Scene scene =
        folder.load("city.obj",
                    "v 2600000.125 1200000 400\nv 2600000.625 1200000 400\nv 2600000.625 1200000.25 400\n"
                    "f 1 2 3\n");
    EXPECT_NEAR(area_of(scene), 0.5 * 0.5 * 0.25, 1e-9);
}

TEST(Obj, TrianglesWithoutAreaAreLeftOutAndCounted) {
    const ImportFolder folder;
    const Scene scene = folder.load("a.obj", kSquare + "f 1 2 3\nf 1 1 2\nf 1 2\n");
    EXPECT_EQ(scene.triangle_count, 1u);
    EXPECT_THAT(warnings_of(scene), HasSubstr("1 triangles without area"));
    EXPECT_THAT(warnings_of(scene), HasSubstr("1 faces of fewer than three corners"));
}

TEST(Obj, WhatIsBrokenIsRefusedWithItsPlace) {
    const ImportFolder folder;
    const struct {
        std::string text;
        const char* says;
    } cases[] = {{kSquare + "f 1 2 9\n", "face 1: names position 9"},
                 {kSquare + "f 1 2 3\nf -5 2 3\n", "face 2: names position -5"},
                 {kSquare + "f 0 1 2\n", "face 1: names position 0"},
                 {kSquare + "f 1/1 2/1 3/1\n", ""},  // without a texture no texture coordinates are needed
                 {kSquare + "f 1//1 2//1 3//1\n", "names normal 1"},
                 {kSquare + "f a b c\n", "line 5: holds what is no finite number"},
                 {"v 0 0 nan\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "line 1: holds what is no finite number"},
                 {"v 0 0 0\nv inf 0 0\nv 1 1 0\nf 1 2 3\n", "line 2: holds what is no finite number"},
                 {"v 0 0 1e39\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "holds the coordinate 1e+39"},
                 {"v 0 0 1e999\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "holds the coordinate"},
                 {"", "no usable geometry"},
                 {kSquare, "no usable geometry"},
                 {"\xFF\xFEv\n", "UTF-16"},
                 {std::string(5000, '\\'), "no usable geometry"},
                 {"f 99999999999999999999 1 2\n", "names position"}};
    for (const auto& c : cases) {
        const std::string refusal = folder.refusal("bad.obj", c.text);
        EXPECT_THAT(refusal, HasSubstr(c.says)) << c.text;
        EXPECT_EQ(refusal.empty(), *c.says == '\0') << c.text;
    }
}

TEST(Obj, ExtensionsAreReadInAnyLetterCase) {
    const ImportFolder folder;
    EXPECT_EQ(folder.load("A.OBJ", kSquare + "f 1 2 3\n").triangle_count, 1u);
    EXPECT_EQ(folder.load("a.Obj", kSquare + "f 1 2 3\n").id, "a");
}

}  // namespace
