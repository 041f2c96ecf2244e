#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using aoscore::Scene;
using aoscore::testing::all_corners;
using aoscore::testing::corners;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;
using nlohmann::json;

/// Five points of a zigzag in the plane z = 0.
const std::vector<float> kZigzag = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0};

void expect_same(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b, double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LE(glm::distance(a[i], b[i]), tolerance) << i;
}

template <class T>
Scene load_indexed(const std::vector<T>& indices, int mode) {
    GltfFile file;
    const int positions = file.add_positions(kZigzag);
    file.add_mesh({{"attributes", {{"POSITION", positions}}},
                   {"indices", file.add_accessor(indices, "SCALAR", 1)},
                   {"mode", mode}});
    file.add_node({{"mesh", 0}});
    return file.load(output_dir());
}

TEST(GltfGeometry, ReadsEveryIndexType) {
    const std::vector<glm::dvec3> expected = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    expect_same(all_corners(load_indexed<std::uint8_t>({2, 1, 0}, 4)), expected, 0);
    expect_same(all_corners(load_indexed<std::uint16_t>({2, 1, 0}, 4)), expected, 0);
    expect_same(all_corners(load_indexed<std::uint32_t>({2, 1, 0}, 4)), expected, 0);
}

TEST(GltfGeometry, TakesStripsApartWithOneWinding) {
    const Scene scene = load_indexed<std::uint16_t>({0, 1, 2, 3, 4}, 5);
    EXPECT_EQ(scene.triangle_count, 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto c = corners(scene, scene.instances[0], i);
        EXPECT_EQ(aoscore::triangle_normal(c[0], c[1], c[2]), glm::dvec3(0, 0, -1)) << i;
    }
}

TEST(GltfGeometry, TakesFansApartAroundTheFirstVertex) {
    // Vertex 2 is right of 0, 3 above it, and 1 left of that: a counter-clockwise fan.
    const Scene scene = load_indexed<std::uint16_t>({0, 2, 3, 1}, 6);
    EXPECT_EQ(scene.triangle_count, 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto c = corners(scene, scene.instances[0], i);
        EXPECT_EQ(aoscore::triangle_normal(c[0], c[1], c[2]), glm::dvec3(0, 0, 1)) << i;
        EXPECT_EQ(c[2], glm::dvec3(0, 0, 0));
    }
}

TEST(GltfGeometry, ReadsMeshesWithoutIndices) {
    GltfFile file;
    file.add_mesh({{"attributes", {{"POSITION", file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
    file.add_node({{"mesh", 0}});
    expect_same(all_corners(file.load(output_dir())), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0);
}

TEST(GltfGeometry, KeepsOnlyVerticesThatAreUsedAndTrianglesWithArea) {
    const Scene scene =
        load_indexed<std::uint16_t>({0, 1, 2, 0, 0, 2, 0, 2, 4}, 4);  // the last two have no area
    EXPECT_EQ(scene.triangle_count, 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("2 triangles without area"), std::string::npos) << scene.warnings[0];
    EXPECT_LE(scene.meshes[0].positions.size(), 4u);
}

TEST(GltfGeometry, SaysWhenNothingIsLeft) {
    GltfFile file;
    file.add_mesh({{"attributes", {{"POSITION", file.add_positions({0, 0, 0, 1, 0, 0, 2, 0, 0})}}}});
    file.add_node({{"mesh", 0}});
    EXPECT_NE(file.refusal(output_dir()).find("no usable geometry"), std::string::npos);
}

TEST(GltfGeometry, ReplacesSparseElements) {
    GltfFile file;
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::uint16_t element = 1;
    const float moved[] = {5, 0, 0};
    file.document["accessors"][static_cast<std::size_t>(positions)]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", file.add_view(&element, 2)}, {"componentType", 5123}}},
        {"values", {{"bufferView", file.add_view(moved, 12)}}}};
    file.add_mesh({{"attributes", {{"POSITION", positions}}}});
    file.add_node({{"mesh", 0}});
    expect_same(all_corners(file.load(output_dir())), {{0, 0, 0}, {5, 0, 0}, {0, 1, 0}}, 0);
}

/// A triangle at steps of a quarter, coded as T; `scale` undoes the coding.
template <class T>
void expect_quantised_triangle(const std::vector<T>& values, bool normalized, double scale) {
    GltfFile file;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int positions = file.add_accessor(values, "VEC3", 3);
    json& accessor = file.document["accessors"][static_cast<std::size_t>(positions)];
    accessor["normalized"] = normalized;
    accessor["min"] = accessor["max"] = {0, 0, 0};
    file.add_mesh({{"attributes", {{"POSITION", positions}}}});
    file.add_node({{"mesh", 0}, {"scale", {scale, scale, scale}}});
    expect_same(all_corners(file.load(output_dir())), {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}, 0.005);
}

TEST(GltfGeometry, ReadsQuantisedPositionsOfEveryType) {
    expect_quantised_triangle<std::int8_t>({0, 0, 0, 4, 0, 0, 0, 2, 0}, false, 0.25);
    expect_quantised_triangle<std::uint8_t>({0, 0, 0, 4, 0, 0, 0, 2, 0}, false, 0.25);
    expect_quantised_triangle<std::int16_t>({0, 0, 0, 400, 0, 0, 0, 200, 0}, false, 0.0025);
    expect_quantised_triangle<std::uint16_t>({0, 0, 0, 400, 0, 0, 0, 200, 0}, false, 0.0025);
    expect_quantised_triangle<std::int8_t>({0, 0, 0, 127, 0, 0, 0, 64, 0}, true, 1);
    expect_quantised_triangle<std::uint8_t>({0, 0, 0, 255, 0, 0, 0, 127, 0}, true, 1);
    expect_quantised_triangle<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, 16384, 0}, true, 1);
    expect_quantised_triangle<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 32768, 0}, true, 1);
}

TEST(GltfGeometry, MatrixAndTranslationRotationScaleAgree) {
    const double h = std::sqrt(0.5);
    GltfFile parts;
    parts.add_box({0, 0, 0}, {1, 2, 3});
    parts.add_node(
        {{"mesh", 0}, {"translation", {5, 6, 7}}, {"rotation", {0, h, 0, h}}, {"scale", {2, 3, 4}}});
    // A quarter turn about y takes z to x and x to -z.
    GltfFile matrix;
    matrix.add_box({0, 0, 0}, {1, 2, 3});
    matrix.add_node({{"mesh", 0}, {"matrix", {0, 0, -2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 5, 6, 7, 1}}});
    const auto folder = output_dir();
    expect_same(all_corners(parts.load(folder)), all_corners(matrix.load(folder)), 1e-12);
}

TEST(GltfGeometry, ParentsTransformTheirChildrenAndMeshesAreShared) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}, {"children", {1, 2}}});
    file.document["nodes"].push_back({{"mesh", 0}, {"translation", {0, 3, 0}}});
    file.document["nodes"].push_back({{"mesh", 0}, {"scale", {-1, 1, 1}}});
    const Scene scene = file.load(output_dir());
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.triangle_count, 24u);
    EXPECT_EQ(glm::dvec3(scene.instances[0].scene_from_mesh[3]), glm::dvec3(10, 6, 0));
    EXPECT_EQ(scene.bounds.low, glm::dvec3(8, 0, 0));
    EXPECT_EQ(scene.bounds.high, glm::dvec3(12, 8, 2));
}

TEST(GltfGeometry, ANodeUnderTwoParentsIsRefused) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"children", {2}}});
    file.add_node({{"children", {2}}});
    file.document["nodes"].push_back({{"mesh", 0}});
    EXPECT_NE(file.refusal(output_dir()).find("nodes[2]: is reached twice"), std::string::npos);
}

TEST(GltfGeometry, NormalsWithoutDirectionComeFromTheFaces) {
    GltfFile file;
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const float nan = std::nanf("");
    const int normals = file.add_accessor<float>({0, 0, 0, 0, 0, 7, nan, 0, 1}, "VEC3", 3);
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    ASSERT_EQ(scene.meshes[0].normals.size(), 3u);
    for (const glm::vec3& n : scene.meshes[0].normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("2 vertex normals"), std::string::npos);
}

TEST(GltfGeometry, AFlatteningScaleKeepsWhatHasAreaAndDropsNormals) {
    GltfFile file;
    file.add_box({-1, -1, -1}, {1, 1, 1});
    file.add_node({{"mesh", 0}, {"scale", {1, 0, 2}}, {"translation", {0, 3, 0}}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.triangle_count, 4u);  // top and bottom, now at one height
    EXPECT_EQ(scene.bounds.low, glm::dvec3(-1, 3, -2));
    EXPECT_EQ(scene.bounds.high, glm::dvec3(1, 3, 2));
    EXPECT_FALSE(scene.warnings.empty());
    EXPECT_NEAR(glm::determinant(scene.instances[0].scene_from_mesh), 1, 1e-12);
}

TEST(GltfGeometry, ManyPrimitivesOverOneLongAccessorStaySmall) {
    GltfFile file;
    std::vector<float> many;
    for (int i = 0; i < 30000; ++i)
        many.insert(many.end(), {static_cast<float>(i), static_cast<float>(i % 2), 0});
    const int positions = file.add_positions(many);
    const int indices = file.add_accessor<std::uint16_t>({0, 1, 2}, "SCALAR", 1);
    json primitives = json::array();
    for (int i = 0; i < 2000; ++i) {
        primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    }
    file.document["meshes"] = {{{"primitives", primitives}}};
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.triangle_count, 2000u);
    for (const auto& mesh : scene.meshes) ASSERT_EQ(mesh.positions.size(), 3u);
}

TEST(GltfGeometry, AFileThatAsksForFarMoreThanItHoldsIsRefused) {
    GltfFile file;
    // Zeros without data are legal, and make a terabyte of triangles.
    file.document["accessors"].push_back({{"componentType", 5126}, {"count", 3000000000u}, {"type", "VEC3"}});
    file.add_mesh({{"attributes", {{"POSITION", 0}}}});
    file.add_node({{"mesh", 0}});
    EXPECT_NE(file.refusal(output_dir()).find("more memory"), std::string::npos);
}

}  // namespace
