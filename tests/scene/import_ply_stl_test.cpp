#include "gltf_file.h"
#include "import_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <regex>
#include <string>
#include <vector>

namespace {

using aoscore::Scene;
using aoscore::testing::area_of;
using aoscore::testing::ImportFolder;
using aoscore::testing::warnings_of;
using ::testing::HasSubstr;

/// The bytes of a number, little-endian or big-endian.
template <class T>
std::string bytes(T value, bool big_endian) {
    std::string text(reinterpret_cast<const char*>(&value), sizeof value);
    if (big_endian) std::reverse(text.begin(), text.end());
    return text;
}

/// An L of area 3 as one polygon.
const glm::vec3 kL[] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

std::string binary_ply(bool big_endian) {
    std::string text = fmt::format(
        "ply\nformat binary_{}_endian 1.0\ncomment made by hand\nelement vertex 6\nproperty double "
        "x\nproperty double y\n"
        "property double z\nproperty uchar red\nelement face 1\nproperty list uchar uint "
        "vertex_index\nend_header\n",
        big_endian ? "big" : "little");
    for (const glm::vec3& p : kL) {
        for (int axis = 0; axis < 3; ++axis) text += bytes(static_cast<double>(p[axis]), big_endian);
        text += '\x7f';
    }
    text += '\6';
    for (std::uint32_t i = 0; i < 6; ++i) text += bytes(i, big_endian);
    return text;
}

std::string text_ply(const std::string& rows, int vertices, int faces, const std::string& more = "") {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n{}",
        vertices, more, faces, rows);
}

TEST(Ply, IsReadAsTextAndInBothByteOrders) {
    const ImportFolder folder;
    std::string rows;
    for (const glm::vec3& p : kL) rows += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    EXPECT_NEAR(area_of(folder.load("a.ply", text_ply(rows + "6 0 1 2 3 4 5\n", 6, 1))), 3.0, 1e-6);
    for (const bool big_endian : {false, true})
        EXPECT_NEAR(area_of(folder.load("a.PLY", binary_ply(big_endian))), 3.0, 1e-6);
}

TEST(Ply, OfBinaryNumbersMayBeginWithAnyByte) {
    const ImportFolder folder;
    // 0x0A is a line feed, 0x0D a carriage return, in the lowest byte of the first coordinate.
    for (const char first : {'\n', '\r', ' ', '\0'}) {
        std::string text = binary_ply(false);
        text[text.find("end_header\n") + 11] = first;
        EXPECT_NEAR(area_of(folder.load("a.ply", text)), 3.0, 1e-6) << static_cast<int>(first);
    }
}

TEST(Ply, HeaderMayEndItsLinesAsAnySystemDoes) {
    const ImportFolder folder;
    const std::string whole = binary_ply(false);
    const std::size_t end = whole.find("end_header\n") + 11;
    for (const std::string line_end : {"\r\n", "\r"}) {
        std::string text = std::regex_replace(whole.substr(0, end), std::regex("\n"), line_end);
        EXPECT_NEAR(area_of(folder.load("a.ply", text + "\n" + whole.substr(end + 1))), 3.0, 1e-6);
    }
}

TEST(Ply, ElementsMayStandInAnyOrderAmongOthers) {
    const ImportFolder folder;
    const Scene scene = folder.load(
        "a.ply",
        "ply\nformat ascii 1.0\nWritten by hand\nobj_info none\nelement camera 2\nproperty float f\n"
        "property list uint8 int8 more\nelement face 1\nproperty uchar red\n"
        "property list uint8 uint32 vertex_index\nelement vertex 3\nproperty float64 z\nproperty float32 "
        "x\nproperty float y\nelement edge 1\nproperty int a\nproperty int b\nend_header\n"
        "1.5 2 7 8\n2.5 0\n255 3 0 1 2\n0 0 0\n0 2 0\n0 0 +2e0\n0 1\n");
    EXPECT_NEAR(area_of(scene), 2.0, 1e-6);
    EXPECT_EQ(warnings_of(scene).find("more than its header"), std::string::npos) << warnings_of(scene);
}

TEST(Ply, StripsAreTrianglesOfOneWinding) {
    const ImportFolder folder;
    // Two squares, each a strip of two triangles; all face +z.
    const Scene scene =
        folder.load("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
                    "float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 -1 2 3 4 5\n");
    EXPECT_EQ(scene.triangle_count, 4u);
    EXPECT_NEAR(area_of(scene), 2.0, 1e-6);
    const std::vector<glm::dvec3> points = aoscore::testing::all_corners(scene);
    for (std::size_t i = 0; i + 2 < points.size(); i += 3)
        EXPECT_GT(glm::cross(points[i + 1] - points[i], points[i + 2] - points[i]).z, 0) << i;
}

TEST(Ply, WhatItsHeaderDoesNotStateIsSaid) {
    const ImportFolder folder;
    const std::string rows = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_THAT(warnings_of(folder.load("a.ply", text_ply(rows + "3 0 1 2\n", 3, 1))),
                HasSubstr("more than its header states"));
    EXPECT_THAT(warnings_of(folder.load("a.ply", text_ply(rows + "2 0 1\n", 3, 2))),
                HasSubstr("1 faces of fewer than three corners"));
    EXPECT_THAT(folder.refusal("points.ply", text_ply("0 0 0\n1 0 0\n0 1 0\n", 3, 0)),
                HasSubstr("3 points are left out"));
}

TEST(Ply, NormalsAreSmoothWhereGiven) {
    const ImportFolder folder;
    const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
    const Scene scene =
        folder.load("a.ply", text_ply("0 0 0 0 0 2\n1 0 0 0 0 2\n0 1 0 0 3 4\n3 0 1 2\n", 3, 1, normals));
    ASSERT_EQ(scene.meshes[0].normals.size(), 3u);
    EXPECT_NEAR(glm::length(scene.meshes[0].normals[2]), 1.0f, 1e-6);
    EXPECT_TRUE(
        folder.load("a.ply", text_ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, 1)).meshes[0].normals.empty());
}

TEST(Ply, WhatIsBrokenIsRefused) {
    const ImportFolder folder;
    const std::string whole = binary_ply(false);
    const struct {
        std::string text;
        const char* says;
    } cases[] = {{"", ""},
                 {"solid", ""},
                 {"ply\n", "within its header"},
                 {"ply\nelement vertex 3\nend_header\n", "no format"},
                 {"ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nend_header\n", "count"},
                 {"ply\nformat ascii 1.0\nelement vertex 9999999999999999999\nend_header\n", "no usable"},
                 {"ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n", "type half"},
                 {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n", "x, y or z"},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", 3, 1), "names vertex 7"},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n", 3, 1), "names vertex -2"},
                 {text_ply("0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", 3, 1), "coordinate"},
                 {text_ply("0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n", 3, 1), "vertex 1"},
                 {text_ply("0 0 1e39\n1 0 0\n0 1 0\n3 0 1 2\n", 3, 1), "coordinate"},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n", 3, 0), "no usable geometry"},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 2000000000, 2000000000), "ends before it"},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", -1, -1), ""},
                 {text_ply("0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", 3, 1), ""},
                 {whole.substr(0, whole.size() - 9), ""},
                 {whole.substr(0, whole.find("end_header") + 30), ""}};
    for (const auto& c : cases) {
        const std::string refusal = folder.refusal("bad.ply", c.text);
        EXPECT_NE(refusal, "") << c.text;
        EXPECT_THAT(refusal, HasSubstr(c.says)) << c.text;
    }
}

const char* const kStlText =
    "solid part\n facet normal 0 0 0\n  outer loop\n   vertex 0 0 0\n   vertex 2 0 0\n   vertex 0 2 0\n  "
    "endloop\n endfacet\n"
    "endsolid part\n";

std::string binary_stl(std::uint32_t triangles) {
    std::string text(80, ' ');
    text.replace(0, 5, "solid");  // many programs begin binary files so
    text += bytes(triangles, false);
    for (const float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 0.f, 2.f, 0.f})
        text += bytes(number, false);
    return text + std::string(2, '\0');
}

TEST(Stl, IsReadAsTextAndBinaryAndIsFlat) {
    const ImportFolder folder;
    for (const std::string& content : {std::string(kStlText), binary_stl(1)}) {
        const Scene scene = folder.load("part.stl", content);
        EXPECT_NEAR(area_of(scene), 2.0, 1e-6);
        EXPECT_TRUE(scene.meshes[0].normals.empty());
    }
}

TEST(Stl, WhatIsBrokenIsRefused) {
    const ImportFolder folder;
    for (const std::string& content :
         {std::string(), std::string("solid"), std::string("solid x\nfacet normal"), binary_stl(4000000000),
          binary_stl(1).substr(0, 100), std::string(84, '\0'),
          std::string("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e39\nvertex 1 0 0\nvertex 0 1 "
                      "0\nendloop\nendfacet\nendsolid\n")}) {
        EXPECT_NE(folder.refusal("bad.stl", content), "") << content;
    }
}

}  // namespace
