#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using aoscore::Image;
using aoscore::LoadOptions;
using aoscore::Scene;
using aoscore::Texture;
using aoscore::testing::GltfFile;
using aoscore::testing::output_dir;
using nlohmann::json;

/// One triangle with texture coordinates (0,0), (1,0), (0,1) and a material with a texture of alpha 255 and
/// 0.
GltfFile textured_file(const json& material, const json& sampler = json::object()) {
    GltfFile file;
    Image<glm::u8vec4> texels(2, 1);
    texels.at(0, 0) = {200, 100, 50, 255};
    texels.at(1, 0) = {200, 100, 50, 0};
    const int texture = file.add_texture(texels, sampler);
    file.document["materials"].push_back(material);
    file.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = texture;
    const int positions = file.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int texcoords = file.add_accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    file.add_mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}}, {"material", 0}});
    file.add_node({{"mesh", 0}});
    return file;
}

TEST(GltfMaterials, MaskIsCutAtItsCutoffAndBlendAtAHalf) {
    GltfFile mask = textured_file({{"alphaMode", "MASK"}, {"alphaCutoff", 0.3}});
    EXPECT_EQ(mask.load(output_dir()).materials[0].alpha_cutoff, 0.3f);
    GltfFile default_mask = textured_file({{"alphaMode", "MASK"}});
    EXPECT_EQ(default_mask.load(output_dir()).materials[0].alpha_cutoff, 0.5f);
    GltfFile blend = textured_file({{"alphaMode", "BLEND"}, {"alphaCutoff", 0.3}});
    EXPECT_EQ(blend.load(output_dir()).materials[0].alpha_cutoff, 0.5f);
}

TEST(GltfMaterials, OpaqueIsNeverCutAndItsTextureNotDecoded) {
    GltfFile file = textured_file(json::object());
    const Scene scene = file.load(output_dir());
    EXPECT_FALSE(scene.materials[0].is_cutout());
    EXPECT_TRUE(scene.textures.empty());
    EXPECT_TRUE(scene.meshes[0].texcoords.empty());
}

TEST(GltfMaterials, AlbedoTexturesAreDecodedWhenAskedForAndDoNotChangeTheDigest) {
    GltfFile file = textured_file(json::object());
    const auto folder = output_dir();
    LoadOptions with_albedo;
    with_albedo.albedo_textures = true;
    const Scene plain = file.load(folder), coloured = file.load(folder, with_albedo);
    ASSERT_EQ(coloured.textures.size(), 1u);
    EXPECT_EQ(coloured.textures[0].texels.at(1, 0), glm::u8vec4(200, 100, 50, 0));
    EXPECT_EQ(coloured.meshes[0].texcoords.size(), 3u);
    EXPECT_FALSE(coloured.materials[0].is_cutout());
    EXPECT_EQ(plain.digest, coloured.digest);
}

TEST(GltfMaterials, ACutOutThatNothingIsCutFromIsSolid) {
    // Half the alpha of every texel is still above the cutoff.
    GltfFile file = textured_file({{"alphaMode", "MASK"}, {"alphaCutoff", 0.0}});
    EXPECT_FALSE(file.load(output_dir()).materials[0].is_cutout());
    GltfFile glass;
    glass.document["materials"] = {
        {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.7}}}}},
        {{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.2}}}}}};
    glass.add_box({0, 0, 0}, {1, 1, 1});
    glass.add_node({{"mesh", 0}});
    const Scene scene = glass.load(output_dir());
    EXPECT_FALSE(scene.materials[0].is_cutout());
    EXPECT_TRUE(scene.materials[1].is_cutout());
}

TEST(GltfMaterials, SamplersWrapAsTheySay) {
    GltfFile file = textured_file({{"alphaMode", "MASK"}}, {{"wrapS", 33071}, {"wrapT", 33648}});
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.textures[0].wrap_s, Texture::Wrap::clamp_to_edge);
    EXPECT_EQ(scene.textures[0].wrap_t, Texture::Wrap::mirrored_repeat);
    GltfFile plain = textured_file({{"alphaMode", "MASK"}});
    EXPECT_EQ(plain.load(output_dir()).textures[0].wrap_s, Texture::Wrap::repeat);
}

TEST(GltfMaterials, TextureTransformTurnsTheWaySpecifiedByItsExample) {
    // This is the extension's example: the lower left quadrant of the image, turned clockwise by a quarter.
    GltfFile file = textured_file({{"alphaMode", "MASK"}});
    file.document["extensionsRequired"] = file.document["extensionsUsed"] = {"KHR_texture_transform"};
    file.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
                 ["KHR_texture_transform"] = {
        {"offset", {0, 1}}, {"rotation", std::numbers::pi / 2}, {"scale", {0.5, 0.5}}};
    const Scene scene = file.load(output_dir());
    const auto& uv = scene.meshes[0].texcoords;
    ASSERT_EQ(uv.size(), 3u);
    EXPECT_LT(glm::distance(uv[0], glm::vec2(0, 1)), 1e-6f);
    EXPECT_LT(glm::distance(uv[1], glm::vec2(0, 0.5)), 1e-6f);
    EXPECT_LT(glm::distance(uv[2], glm::vec2(0.5, 1)), 1e-6f);
}

TEST(GltfMaterials, TheNamedSetOfTextureCoordinatesIsUsed) {
    GltfFile file = textured_file({{"alphaMode", "MASK"}});
    file.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1;
    // Normalised bytes are legal without an extension.
    const int second = file.add_accessor<std::uint8_t>({0, 255, 51, 0, 0, 0}, "VEC2", 2);
    file.document["accessors"].back()["normalized"] = true;
    file.document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = second;
    const Scene scene = file.load(output_dir());
    EXPECT_EQ(scene.meshes[0].texcoords[0], glm::vec2(0, 1));
    EXPECT_NEAR(scene.meshes[0].texcoords[1].x, 0.2f, 1e-6f);
}

TEST(GltfMaterials, ABrokenImageMakesACutOutSolidWithAWarning) {
    GltfFile file = textured_file({{"alphaMode", "MASK"}});
    file.document["images"][0] = {{"uri", "not-there.png"}};
    const Scene scene = file.load(output_dir());
    EXPECT_FALSE(scene.materials[0].is_cutout());
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("images[0]"), std::string::npos);
}

}  // namespace
