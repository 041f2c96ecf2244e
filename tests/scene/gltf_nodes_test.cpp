#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace {

using aoscore::Scene;
using aoscore::testing::all_corners;
using aoscore::testing::GltfFile;
using aoscore::testing::has_warning;
using aoscore::testing::output_dir;
using nlohmann::json;

json hidden(bool visible = false) {
    return {{"KHR_node_visibility", {{"visible", visible}}}};
}

TEST(GltfVisibility, AHiddenNodeHidesItselfAndAllBelowIt) {
    GltfFile file;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {"KHR_node_visibility"};
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    file.add_node({{"mesh", 0}, {"translation", {5, 0, 0}}, {"children", {2}}, {"extensions", hidden()}});
    // The node is visible itself, but its parent is not.
    file.document["nodes"].push_back({{"mesh", 0}, {"extensions", hidden(true)}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.bounds.high, glm::dvec3(1));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfVisibility, ASceneOfWhichAllIsHiddenIsRefused) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}, {"extensions", hidden()}});
    EXPECT_NE(file.refusal(output_dir()).find("no usable geometry"), std::string::npos);
}

json target(int node) {
    return {{"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}};
}

std::vector<bool> moving(const Scene& scene) {
    std::vector<bool> moves;
    for (const aoscore::Instance& instance : scene.instances) moves.push_back(instance.is_dynamic);
    return moves;
}

TEST(GltfMovement, IsThatOfNodesThatAnAnimationTargetsAndOfAllBelowThem) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    file.add_node({{"mesh", 0}, {"translation", {5, 0, 0}}, {"children", {2}}});
    file.document["nodes"].push_back({{"mesh", 0}, {"translation", {0, 3, 0}}});
    EXPECT_EQ(moving(file.load(output_dir())), (std::vector<bool>{false, false, false}));
    const std::string still = file.load(output_dir()).digest;
    file.document["animations"] = {target(1)};
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(moving(scene), (std::vector<bool>{false, true, true}));
    EXPECT_NE(scene.digest, still) << "what is drawn by it would be taken from the cache";
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMovement, IsWhatTheExtrasOfANodeSay) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}, {"extras", {{"dynamic", true}}}});
    file.add_node({{"mesh", 0}, {"translation", {5, 0, 0}}, {"children", {2}}});
    file.document["nodes"].push_back(
        {{"mesh", 0}, {"translation", {0, 3, 0}}, {"extras", {{"dynamic", false}}}});
    file.document["animations"] = {target(1)};
    EXPECT_EQ(moving(file.load(output_dir())), (std::vector<bool>{true, true, false}));
}

// Blender writes 1 for true.
TEST(GltfMovement, IsSaidByOneAndZeroTooAndByNothingElse) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    for (const auto& [said, moves] : std::map<std::string, bool>{{"1", true}, {"0", false}, {"1.0", true}}) {
        file.document["nodes"][0]["extras"] = {{"dynamic", json::parse(said)}};
        const Scene scene = file.load(output_dir());
        EXPECT_EQ(moving(scene), std::vector<bool>{moves}) << said;
        EXPECT_TRUE(scene.warnings.empty()) << said;
    }
    for (const char* said : {"2", "\"yes\"", "[true]", "{\"is\": true}"}) {
        file.document["nodes"][0]["extras"] = {{"dynamic", json::parse(said)}};
        const Scene scene = file.load(output_dir());
        EXPECT_EQ(moving(scene), std::vector<bool>{false}) << said;
        EXPECT_TRUE(has_warning(scene, "nodes[0].extras.dynamic")) << said;
    }
}

TEST(GltfMovement, IsThatOfANodeWhosePropertyAPointerAnimates) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    const auto animate = [&](const std::string& pointer) {
        const json extensions = {{"KHR_animation_pointer", {{"pointer", pointer}}}};
        file.document["animations"] = {
            {{"channels", {{{"target", {{"path", "pointer"}, {"extensions", extensions}}}}}}}};
        return moving(file.load(output_dir()));
    };
    EXPECT_EQ(animate("/nodes/0/translation"), std::vector<bool>{true});
    for (const char* other : {"/materials/0/emissiveFactor", "/nodes/", "/nodes/x/scale",
                              "/nodes/99999999999/scale", ""})
        EXPECT_EQ(animate(other), std::vector<bool>{false}) << other;
}

TEST(GltfMovement, IsThatOfASkinWithAJointThatMoves) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    json& attributes = file.document["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t vertices = file.document["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
    attributes["JOINTS_0"] = file.add_accessor(std::vector<std::uint8_t>(4 * vertices, 0), "VEC4", 4);
    std::vector<float> weights(4 * vertices, 0.0F);
    for (std::size_t i = 0; i < vertices; ++i) weights[4 * i] = 1;
    attributes["WEIGHTS_0"] = file.add_accessor(weights, "VEC4", 4);
    file.document["skins"] = json::array({json{{"joints", json::array({1})}}});
    file.add_node({{"mesh", 0}, {"skin", 0}});
    file.add_node({{"translation", {0, 2, 0}}});
    EXPECT_EQ(moving(file.load(output_dir())), std::vector<bool>{false});
    file.document["animations"] = {target(1)};
    EXPECT_EQ(moving(file.load(output_dir())), std::vector<bool>{true});
}

// Nothing of an animation is drawn: one that makes no sense is no reason to refuse a file.
TEST(GltfMovement, IsNotRefusedForWhatAnAnimationHolds) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.add_node({{"mesh", 0}});
    for (const char* broken :
         {R"([{}])", R"([{"channels": 3}])",
          R"([{"channels": [7, {"target": []}, {"target": {"node": 99}}]}])",
          R"([{"channels": [{"target": {"node": "0"}}, {"target": {"node": -1}}, {"target": null}]}])"}) {
        file.document["animations"] = json::parse(broken);
        EXPECT_EQ(moving(file.load(output_dir())), std::vector<bool>{false}) << broken;
    }
}

/// A box at a node moved by (10, 0, 0) and doubled, with these instances.
GltfFile instanced(const std::vector<float>& translations, const std::vector<float>& rotations,
                   const std::vector<float>& scales) {
    GltfFile file;
    file.add_box({0, 0, 0}, {1, 1, 1});
    json attributes;
    if (!translations.empty()) attributes["TRANSLATION"] = file.add_accessor(translations, "VEC3", 3);
    if (!rotations.empty()) attributes["ROTATION"] = file.add_accessor(rotations, "VEC4", 4);
    if (!scales.empty()) attributes["SCALE"] = file.add_accessor(scales, "VEC3", 3);
    attributes["_ID"] = 0;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    file.add_node({{"mesh", 0},
                   {"translation", {10, 0, 0}},
                   {"scale", {2, 2, 2}},
                   {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
    return file;
}

TEST(GltfInstancing, InstancesShareOneMeshAndAreTurnedThenMovedThenPlacedByTheirNode) {
    const float h = static_cast<float>(std::sqrt(0.5));
    // The second has a quarter turn about y, which takes x to -z and z to x.
    const Scene scene =
        instanced({0, 0, 0, 0, 5, 0}, {0, 0, 0, 1, 0, h, 0, h}, {1, 1, 1, 3, 1, 1}).load(output_dir());
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(glm::dvec3(scene.instances[0].scene_from_mesh * glm::dvec4(1, 1, 1, 1)), glm::dvec3(12, 2, 2));
    const glm::dvec3 corner(scene.instances[1].scene_from_mesh * glm::dvec4(1, 1, 1, 1));
    EXPECT_LT(glm::distance(corner, glm::dvec3(10 + 2 * 1, 2 * (5 + 1), -2 * 3)), 1e-5);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfInstancing, RotationsMayBeNormalisedIntegersAndAnyAttributeMayBeMissing) {
    GltfFile file = instanced({}, {}, {1, 1, 1, 2, 2, 2, 0, 0, 0});
    const int rotations =
        file.add_accessor<std::int16_t>({0, 0, 0, 32767, 0, 32767, 0, 0, 0, 0, 0, 0}, "VEC4", 4);
    file.document["accessors"].back()["normalized"] = true;
    file.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] = rotations;
    const Scene scene = file.load(output_dir());
    ASSERT_EQ(scene.instances.size(), 2u);  // the third is scaled to nothing
    // The second has half a turn about y.
    EXPECT_LT(glm::distance(glm::dvec3(scene.instances[1].scene_from_mesh * glm::dvec4(1, 1, 1, 1)),
                            glm::dvec3(6, 4, -4)),
              1e-5);
    EXPECT_TRUE(has_warning(scene, "rotations of length 0"));
}

TEST(GltfInstancing, CountsThatDifferAndAbsurdOnesAreRefused) {
    EXPECT_NE(instanced({0, 0, 0, 1, 1, 1}, {}, {1, 1, 1}).refusal(output_dir()).find("another attribute 2"),
              std::string::npos);
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_NE(instanced({0, 0, infinity}, {}, {}).refusal(output_dir()).find("instance 0 is not finite"),
              std::string::npos);
    for (const std::int64_t count : {std::int64_t{1} << 32, std::int64_t{1} << 40}) {
        GltfFile file = instanced({}, {}, {});
        file.document["accessors"].push_back({{"componentType", 5126}, {"count", count}, {"type", "VEC3"}});
        file.document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
            file.document["accessors"].size() - 1;
        EXPECT_NE(file.refusal(output_dir()), "") << count;
    }
}

TEST(GltfScenes, TheNamedSceneIsDrawnAndWithoutANameTheFirst) {
    for (const bool named : {true, false}) {
        GltfFile file;
        file.add_box({0, 0, 0}, {1, 1, 1});
        file.add_node({{"mesh", 0}});
        file.document["nodes"].push_back({{"mesh", 0}, {"scale", {7, 7, 7}}});
        file.document["scenes"].push_back({{"nodes", {1}}});
        if (named) {
            file.document["scene"] = 1;
        } else {
            file.document.erase("scene");
        }
        const Scene scene = file.load(output_dir());
        EXPECT_EQ(scene.bounds.high.x, named ? 7 : 1);
        EXPECT_TRUE(has_warning(scene, named ? "scenes[1] of 2 is drawn" : "scenes[0] of 2 is drawn"));
    }
}

}  // namespace
