#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using aoscore::Scene;
using aoscore::testing::all_corners;
using aoscore::testing::GltfFile;
using aoscore::testing::has_warning;
using aoscore::testing::output_dir;
using nlohmann::json;

void expect_corners(const Scene& scene, const std::vector<glm::dvec3>& expected) {
    const auto corners = all_corners(scene);
    ASSERT_EQ(corners.size(), expected.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        EXPECT_LT(glm::distance(corners[i] + scene.origin, expected[i]), 1e-6)
            << i << ": " << corners[i].x << " " << corners[i].y << " " << corners[i].z;
    }
}

/// A column-major translation.
std::vector<float> translation(float x, float y, float z) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

struct Weights {
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
};

/// A triangle (0,0,0), (1,0,0), (0,1,0) that two joints hold: one at `first`, one 2 above it. The node that
/// shows it is moved far away.
GltfFile skinned(const Weights& w, const glm::vec3& first = {0, 0, 0}) {
    GltfFile file;
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = file.add_accessor(w.joints, "VEC4", 4);
    const int weights = file.add_accessor(w.weights, "VEC4", 4);
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    file.add_node({{"mesh", 0}, {"skin", 0}, {"translation", {1000, 0, 0}}, {"scale", {5, 5, 5}}});
    file.add_node({{"translation", {first.x, first.y, first.z}}, {"children", {2}}});
    file.document["nodes"].push_back({{"translation", {0, 2, 0}}});
    std::vector<float> binds = translation(0, 0, 0);
    const std::vector<float> second = translation(0, -1, 0);
    binds.insert(binds.end(), second.begin(), second.end());
    file.document["skins"] = {
        {{"joints", {1, 2}}, {"inverseBindMatrices", file.add_accessor(binds, "MAT4", 16)}}};
    return file;
}

const Weights kHalfHeld = {{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}};

TEST(GltfSkins, VerticesFollowTheirJointsAndTheNodesOwnTransformDoesNotCount) {
    // Joint 1 stands at height 2 and was bound at height 1: it lifts vertices by 1, and the third by a half.
    expect_corners(skinned(kHalfHeld).load(output_dir()), {{0, 0, 0}, {1, 1, 0}, {0, 1.5, 0}});
    expect_corners(skinned(kHalfHeld, {3, 0, 0}).load(output_dir()), {{3, 0, 0}, {4, 1, 0}, {3, 1.5, 0}});
}

TEST(GltfSkins, KeepTheirShapeFarFromTheOrigin) {
    const Scene scene = skinned(kHalfHeld, {1 << 24, 0, 0}).load(output_dir());
    const double x = 1 << 24;
    expect_corners(scene, {{x, 0, 0}, {x + 1, 1, 0}, {x, 1.5, 0}});
}

TEST(GltfSkins, WeightsAreDividedByTheirSumAndAVertexWithoutAnyFollowsItsFirstJoint) {
    Weights w = kHalfHeld;
    w.weights = {0.2f, 0, 0, 0, 0, 0, 0, 0, 0.25f, 0.25f, 0, 0};
    const Scene scene = skinned(w).load(output_dir());
    expect_corners(scene, {{0, 0, 0}, {1, 1, 0}, {0, 1.5, 0}});
    EXPECT_TRUE(has_warning(scene, "no weights"));
}

TEST(GltfSkins, AJointThatTheSkinLacksIsRefusedUnlessItsWeightIsZero) {
    Weights w = kHalfHeld;
    w.joints[3] = 99;  // of weight 0
    EXPECT_EQ(skinned(w).refusal(output_dir()), "");
    w.joints[4] = 99;
    EXPECT_NE(skinned(w).refusal(output_dir()).find("vertex 1 follows joint 99 of 2"), std::string::npos);
}

TEST(GltfSkins, NormalsAreTurnedWithTheirJoints) {
    GltfFile file = skinned({{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}});
    const double h = std::sqrt(0.5);
    file.document["nodes"][1]["rotation"] = {h, 0, 0, h};  // a quarter turn about x: z to -y
    file.document["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        file.add_accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
    const Scene scene = file.load(output_dir());
    expect_corners(scene, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
    for (const glm::vec3& n : scene.meshes[0].normals)
        EXPECT_LT(glm::distance(n, glm::vec3(0, -1, 0)), 1e-6f);
}

TEST(GltfSkins, WithoutInverseBindMatricesTheyAreIdentitiesAndTooFewAreRefused) {
    GltfFile file = skinned(kHalfHeld);
    file.document["skins"][0].erase("inverseBindMatrices");
    expect_corners(file.load(output_dir()), {{0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
    GltfFile few = skinned(kHalfHeld);
    few.document["accessors"].back()["count"] = 1;
    EXPECT_NE(few.refusal(output_dir()).find("1 matrices for 2 joints"), std::string::npos);
}

TEST(GltfSkins, OneMeshWithTwoSkinsStandsInTwoPlaces) {
    GltfFile file = skinned(kHalfHeld);
    file.document["skins"].push_back({{"joints", {1, 2}}});
    file.add_node({{"mesh", 0}, {"skin", 1}});
    const Scene scene = file.load(output_dir());
    ASSERT_EQ(scene.instances.size(), 2u);
    expect_corners(scene, {{0, 0, 0}, {1, 1, 0}, {0, 1.5, 0}, {0, 0, 0}, {1, 2, 0}, {0, 2, 0}});
}

/// A triangle with two morph targets: one moves the second vertex by (0, 0, 4), one the third by (0, 6, 0).
GltfFile morphed(const json& mesh_weights, const json& node_weights) {
    GltfFile file;
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int first = file.add_accessor<float>({0, 0, 0, 0, 0, 4, 0, 0, 0}, "VEC3", 3);
    const int second = file.add_accessor<float>({0, 0, 0, 0, 0, 0, 0, 6, 0}, "VEC3", 3);
    file.add_mesh({{"attributes", {{"POSITION", positions}}},
                   {"targets", {{{"POSITION", first}}, {{"POSITION", second}}}}});
    if (!mesh_weights.is_null()) file.document["meshes"][0]["weights"] = mesh_weights;
    json node = {{"mesh", 0}};
    if (!node_weights.is_null()) node["weights"] = node_weights;
    file.add_node(node);
    return file;
}

TEST(GltfMorphs, TargetsAreAddedByTheNodesWeightsElseTheMeshsElseNotAtAll) {
    const auto folder = output_dir();
    expect_corners(morphed({}, {}).load(folder), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    expect_corners(morphed({0.5, 0}, {}).load(folder), {{0, 0, 0}, {1, 0, 2}, {0, 1, 0}});
    expect_corners(morphed({0.5, 0}, {0.25, 1}).load(folder), {{0, 0, 0}, {1, 0, 1}, {0, 7, 0}});
    expect_corners(morphed({0.5, 0}, {0, 0}).load(folder), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST(GltfMorphs, NodesOfEqualWeightsShareAMeshAndOthersDoNot) {
    GltfFile file = morphed({0.5, 0}, {});
    file.add_node({{"mesh", 0}, {"weights", {0.5, 0}}, {"translation", {9, 0, 0}}});
    file.add_node({{"mesh", 0}, {"weights", {0, 0.5}}, {"translation", {18, 0, 0}}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u);
}

TEST(GltfMorphs, AnotherNumberOfWeightsIsAWarningAndATargetOfAnotherLengthRefused) {
    const Scene scene = morphed({0.5}, {}).load(output_dir());
    EXPECT_TRUE(has_warning(scene, "2 morph targets and 1 weights"));
    GltfFile file = morphed({1, 0}, {});
    file.document["accessors"][1]["count"] = 2;
    EXPECT_NE(file.refusal(output_dir()).find("has 2 elements, the attribute has 3"), std::string::npos);
}

}  // namespace
