#include "gltf_file.h"
#include "scene/gltf/extensions.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <set>

namespace {

using aoscore::Scene;
using aoscore::testing::GltfFile;
using aoscore::testing::has_warning;
using aoscore::testing::output_dir;
using nlohmann::json;

/// A box of a material, with a camera.
GltfFile box() {
    GltfFile file;
    file.document["materials"] = {{{"pbrMetallicRoughness", json::object()}}};
    file.add_box({0, 0, 0}, {1, 1, 1});
    file.document["meshes"][0]["primitives"][0]["material"] = 0;
    file.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    file.add_node({{"mesh", 0}});
    file.add_node({{"camera", 0}, {"translation", {0, 0, 5}}});
    return file;
}

struct Trifle {
    const char* name;
    std::function<void(json&)> spoil;
    const char* warning;  // part of the warning; empty: none is given
};

/// Faults that every viewer accepts, since their meaning is clear.
const std::vector<Trifle>& trifles() {
    static const std::vector<Trifle> all = {
        {"factor",
         [](json& d) {
             d["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1.00000012, 1, 1};
         },
         "clamped to 0 to 1"},
        {"rotation",
         [](json& d) {
             d["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "rotations of length 0"},
        {"matrix",
         [](json& d) {
             d["nodes"][0]["matrix"] = {1, 0, 0, 1e-8, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.9999999};
         },
         ""},
        {"cutoff", [](json& d) { d["materials"][0]["alphaCutoff"] = -0.5; }, "nothing is cut"},
        {"aspect", [](json& d) { d["cameras"][0]["perspective"]["aspectRatio"] = 0; }, "not used"},
        {"min",
         [](json& d) {
             d["accessors"][0]["min"] = {nullptr, nullptr, nullptr};
         },
         "min or max"},
        {"mesh",
         [](json& d) {
             d["meshes"].push_back({{"primitives", json::array()}});
         },
         "without primitives"},
        {"texcoords", [](json& d) { d["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = 0; },
         "TEXCOORD set without"},
        {"count",  // the count of an accessor that nothing reads
         [](json& d) {
             d["accessors"].push_back({{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}});
         },
         ""},
        {"unknown", [](json& d) { d["extensionsUsed"] = {"ACME_trees"}; }, "ACME_trees is unknown here"},
        {"carried", [](json& d) { d["nodes"][0]["extensions"]["ACME_fur"]["length"] = 2; },
         "ACME_fur is unknown here"},
        {"unread", [](json& d) { d["extensionsUsed"] = {"NV_materials_mdl"}; },
         "NV_materials_mdl is not read"},
        {"colours",
         [](json& d) { d["extensionsUsed"] = d["extensionsRequired"] = {"KHR_materials_transmission"}; }, ""},
    };
    return all;
}

TEST(GltfTrifles, AreWarningsAndTheBoxIsThere) {
    for (const Trifle& trifle : trifles()) {
        GltfFile file = box();
        trifle.spoil(file.document);
        const Scene scene = file.load(output_dir());
        EXPECT_EQ(scene.triangle_count, 12u) << trifle.name;
        EXPECT_EQ(scene.bounds.high, glm::dvec3(1)) << trifle.name;
        if (std::string(trifle.warning).empty()) {
            EXPECT_TRUE(scene.warnings.empty()) << trifle.name << ": " << scene.warnings[0];
        } else {
            EXPECT_TRUE(has_warning(scene, trifle.warning)) << trifle.name;
        }
    }
}

TEST(GltfTrifles, QuantisedAttributesAreReadWhereTheExtensionIsNotDeclared) {
    GltfFile file;
    const int positions = file.add_accessor<std::int16_t>({0, 0, 0, 0, 4, 0, 0, 0, 0, 4, 0, 0}, "VEC3", 3);
    json& accessor = file.document["accessors"][0];
    accessor["min"] = accessor["max"] = {0, 0, 0};
    accessor["count"] = 3;
    file.document["bufferViews"][0]["byteStride"] = 8;
    file.add_mesh({{"attributes", {{"POSITION", positions}}}});
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.bounds.high, glm::dvec3(4, 4, 0));
    EXPECT_TRUE(has_warning(scene, "lacks KHR_mesh_quantization"));
}

TEST(GltfTrifles, AWrongEndingOfTheNameIsAWarning) {
    const auto folder = output_dir();
    const auto path = box().write(folder);
    std::filesystem::rename(path, folder / "test.glb");
    EXPECT_TRUE(has_warning(aoscore::load_scene((folder / "test.glb").string()), "is JSON, though"));
}

TEST(GltfTrifles, WhatHasNoMeaningIsStillRefused) {
    const std::vector<std::pair<const char*, std::function<void(json&)>>> cases = {
        {"last row",
         [](json& d) { d["nodes"][0]["matrix"] = {1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }},
        {"alphaMode", [](json& d) { d["materials"][0]["alphaMode"] = "mask"; }},
        {"znear", [](json& d) { d["cameras"][0]["perspective"]["znear"] = 0; }},
        {"count 0 of a mesh", [](json& d) { d["accessors"][0]["count"] = 0; }},
        {"unknown required", [](json& d) { d["extensionsRequired"] = {"ACME_trees"}; }},
        {"required, not read", [](json& d) { d["extensionsRequired"] = {"NV_materials_mdl"}; }},
        {"factor",
         [](json& d) {
             d["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1};
         }},
    };
    for (const auto& [name, spoil] : cases) {
        GltfFile file = box();
        spoil(file.document);
        EXPECT_NE(file.refusal(output_dir()), "") << name;
    }
}

TEST(GltfExtensions, StandInTheTableOnceAndSayWhatIsLost) {
    std::set<std::string_view> names;
    for (const auto& extension : aoscore::gltf::extensions()) {
        EXPECT_TRUE(names.insert(extension.name).second) << extension.name;
        const bool loses = extension.effect == aoscore::gltf::Extension::Effect::surfaces;
        EXPECT_EQ(loses, !extension.loss.empty()) << extension.name;
        EXPECT_EQ(loses, !aoscore::gltf::loss_without(std::string(extension.name)).empty());
        EXPECT_EQ(loses, !aoscore::gltf::is_honoured(extension.name));
    }
}

TEST(GltfExtensions, AVariantThatMayCutOtherHolesIsNamed) {
    for (const char* mode : {"OPAQUE", "MASK"}) {
        GltfFile file = box();
        file.document["materials"].push_back({{"alphaMode", mode}});
        file.document["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "a"}}};
        file.document["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
            {{"material", 1}, {"variants", {0}}}};
        EXPECT_EQ(has_warning(file.load(output_dir()), "KHR_materials_variants"),
                  std::string(mode) == "MASK");
    }
}

}  // namespace
