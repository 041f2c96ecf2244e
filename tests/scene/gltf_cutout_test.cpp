#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using aoscore::Image;
using aoscore::Scene;
using aoscore::testing::GltfFile;
using aoscore::testing::has_warning;
using aoscore::testing::output_dir;
using nlohmann::json;

/// A triangle of a MASK material with COLOR_0 of these values.
template <class T>
GltfFile coloured_file(const std::vector<T>& colours, const std::string& type, int components) {
    GltfFile file;
    file.document["materials"] = {{{"alphaMode", "MASK"}}};
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int accessor = file.add_accessor(colours, type, components);
    file.document["accessors"].back()["normalized"] = !std::is_floating_point_v<T>;
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"COLOR_0", accessor}}}, {"material", 0}});
    file.add_node({{"mesh", 0}});
    return file;
}

TEST(GltfCutOuts, TheVerticesAlphaOfEveryTypeCuts) {
    const std::vector<float> expected = {1, 0.2f, 0};
    const auto alphas = [](GltfFile file) {
        const Scene scene = file.load(output_dir());
        EXPECT_TRUE(scene.materials[0].is_cutout());
        EXPECT_EQ(scene.meshes[0].alphas.size(), 3u);
        return scene.meshes[0].alphas;
    };
    EXPECT_EQ(alphas(coloured_file<float>({1, 1, 1, 1, 1, 1, 1, 0.2f, 1, 1, 1, 0}, "VEC4", 4)), expected);
    EXPECT_EQ(alphas(coloured_file<std::uint8_t>({1, 1, 1, 255, 1, 1, 1, 51, 1, 1, 1, 0}, "VEC4", 4)),
              expected);
    EXPECT_EQ(alphas(coloured_file<std::uint16_t>({1, 1, 1, 65535, 1, 1, 1, 13107, 1, 1, 1, 0}, "VEC4", 4)),
              expected);
    // These values are out of range, or no numbers.
    EXPECT_EQ(alphas(coloured_file<float>({1, 1, 1, std::nanf(""), 1, 1, 1, 0.2f, 1, 1, 1, -3}, "VEC4", 4)),
              expected);
}

TEST(GltfCutOuts, ColoursWithoutAlphaAndThoseOfOpaqueMaterialsCutNothing) {
    const Scene rgb = coloured_file<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", 3).load(output_dir());
    EXPECT_FALSE(rgb.materials[0].is_cutout());
    EXPECT_TRUE(rgb.meshes[0].alphas.empty());
    GltfFile opaque = coloured_file<float>({1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}, "VEC4", 4);
    opaque.document["materials"][0]["alphaMode"] = "OPAQUE";
    EXPECT_TRUE(opaque.load(output_dir()).meshes[0].alphas.empty());
}

TEST(GltfCutOuts, AMaterialThatOnlySomeMeshesCutStaysACutOut) {
    GltfFile file = coloured_file<float>({1, 1, 1, 1, 1, 1, 1, 0.2f, 1, 1, 1, 0}, "VEC4", 4);
    file.add_mesh({{"attributes", {{"POSITION", 0}}}, {"material", 0}});
    file.add_node({{"mesh", 1}, {"translation", {3, 0, 0}}});
    const Scene scene = file.load(output_dir());
    EXPECT_TRUE(scene.materials[0].is_cutout());
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_TRUE(scene.meshes[1].alphas.empty());
}

TEST(GltfCutOuts, VertexAlphaChangesTheDigestOfCutOutsAlone) {
    const auto digest = [](float alpha, const char* mode) {
        GltfFile file = coloured_file<float>({1, 1, 1, 0, 1, 1, 1, alpha, 1, 1, 1, 0}, "VEC4", 4);
        file.document["materials"][0]["alphaMode"] = mode;
        return file.load(output_dir()).digest;
    };
    EXPECT_NE(digest(1, "MASK"), digest(0.9f, "MASK"));
    EXPECT_EQ(digest(1, "OPAQUE"), digest(0.9f, "OPAQUE"));
}

TEST(GltfCutOuts, TheDiffuseAlphaOfSpecularGlossinessCounts) {
    GltfFile file;
    Image<glm::u8vec4> texels(2, 1);
    texels.at(0, 0) = {9, 9, 9, 255};
    texels.at(1, 0) = {9, 9, 9, 0};
    const int texture = file.add_texture(texels);
    file.document["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness", "KHR_texture_transform"};
    file.document["materials"] = {
        {{"alphaMode", "MASK"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 1}}}},
         {"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {1, 1, 1, 0.75}},
             {"diffuseTexture",
              {{"index", texture},
               {"texCoord", 0},
               {"extensions", {{"KHR_texture_transform", {{"scale", {2, 1}}}}}}}}}}}}}};
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int texcoords = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}}, {"material", 0}});
    file.add_node({{"mesh", 0}});
    const Scene scene = file.load(output_dir());
    EXPECT_TRUE(scene.materials[0].is_cutout());
    EXPECT_EQ(scene.materials[0].base_color.a, 0.75f);
    ASSERT_EQ(scene.materials[0].texture, 0);
    EXPECT_EQ(scene.meshes[0].texcoords[1], glm::vec2(2, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

/// A cut-out whose texture has its image by an extension.
Scene load_with_image_of(const std::string& extension, const std::string& first_bytes, bool with_own_image) {
    GltfFile file;
    Image<glm::u8vec4> texels(1, 1);
    texels.at(0, 0) = {9, 9, 9, 0};
    file.add_texture(texels);
    const int view = file.add_view(first_bytes.data(), first_bytes.size());
    file.document["images"].push_back({{"bufferView", view}, {"mimeType", "image/other"}});
    json& texture = file.document["textures"][0];
    texture["extensions"][extension]["source"] = 1;
    if (!with_own_image) texture.erase("source");
    file.document["extensionsUsed"] = {extension};
    file.document["materials"] = {
        {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    const int texcoords = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}}, {"material", 0}});
    file.add_node({{"mesh", 0}});
    return file.load(output_dir());
}

TEST(GltfCutOuts, AnImageThatIsNotDecodedIsNamedAndGltfsOwnIsTakenWhereThereIsOne) {
    const std::string ktx2("\xABKTX 20\xBB\r\n\x1A\n", 12);
    const std::string avif(
        "\0\0\0\x20"
        "ftypavif",
        12);
    for (const auto& [extension, bytes, format] :
         {std::tuple(std::string("KHR_texture_basisu"), ktx2, "KTX2"),
          std::tuple(std::string("MSFT_texture_dds"), std::string("DDS |"), "DDS"),
          std::tuple(std::string("EXT_texture_avif"), avif, "AVIF")}) {
        const Scene alone = load_with_image_of(extension, bytes, false);
        EXPECT_FALSE(alone.materials[0].is_cutout());
        EXPECT_TRUE(has_warning(alone, format)) << extension;
        EXPECT_TRUE(has_warning(alone, "materials[0] is drawn solid")) << extension;
        const Scene both = load_with_image_of(extension, bytes, true);
        EXPECT_TRUE(both.materials[0].is_cutout()) << extension;
        EXPECT_TRUE(both.warnings.empty()) << both.warnings[0];
    }
}

}  // namespace
