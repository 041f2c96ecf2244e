#include "import_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

namespace {

using aoscore::Image;
using aoscore::Material;
using aoscore::Scene;
using aoscore::testing::ImportFolder;
using aoscore::testing::warnings_of;
using ::testing::HasSubstr;

const std::string kLeaf =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl leaf\n"
    "f 1/1 2/2 3/3 4/4\n";

/// Two by two texels, of which only the one at the top left is a hole.
Image<glm::u8vec4> top_left_hole(bool in_alpha) {
    Image<glm::u8vec4> texels(2, 2, glm::u8vec4(255));
    texels.at(0, 0) = in_alpha ? glm::u8vec4(255, 255, 255, 0) : glm::u8vec4(0, 0, 0, 255);
    return texels;
}

float alpha_of(const Scene& scene, const glm::vec2& uv) {
    return aoscore::alpha_at(scene, scene.materials.at(static_cast<std::size_t>(scene.meshes.at(0).material)),
                             uv);
}

const Material& material_of(const Scene& scene) {
    return scene.materials.at(static_cast<std::size_t>(scene.meshes.at(0).material));
}

/// The scene's texture coordinates at a corner of the square, found by its position.
glm::vec2 texcoord_at(const Scene& scene, const glm::vec3& position) {
    const aoscore::Mesh& mesh = scene.meshes.at(0);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i] == position) return mesh.texcoords.at(i);
    }
    ADD_FAILURE() << "no such vertex";
    return {};
}

TEST(Cutouts, ComeFromGreyOpacityImagesTheRightWayUp) {
    const ImportFolder folder;
    folder.write("a.mtl", "newmtl leaf\nKd 1 1 1\nmap_d mask.png\n");
    folder.write_png("mask.png", top_left_hole(false));
    const Scene scene = folder.load("a.obj", kLeaf);
    EXPECT_EQ(material_of(scene).alpha_cutoff, 0.5f);
    // OBJ's v runs up: the image's top left is the corner at (0, 1).
    const glm::vec2 top_left = texcoord_at(scene, {0, 1, 0}), bottom_left = texcoord_at(scene, {0, 0, 0});
    const glm::vec2 inside = glm::mix(top_left, texcoord_at(scene, {1, 0, 0}), 0.25f);
    EXPECT_EQ(alpha_of(scene, inside), 0.0f);
    EXPECT_EQ(alpha_of(scene, glm::mix(bottom_left, texcoord_at(scene, {1, 1, 0}), 0.25f)), 1.0f);
}

TEST(Cutouts, ComeFromTheAlphaOfOpacityImages) {
    const ImportFolder folder;
    folder.write("a.mtl", "newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\n");
    folder.write_png("leaf.png", top_left_hole(true));
    const Scene scene = folder.load("a.obj", kLeaf);
    EXPECT_TRUE(material_of(scene).is_cutout());
    EXPECT_EQ(alpha_of(scene, {0.25f, 0.25f}), 0.0f);
}

TEST(Cutouts, ComeFromTheAlphaOfColoursThatIsAStencilAndSaySo) {
    const ImportFolder folder;
    folder.write("a.mtl", "newmtl leaf\nmap_Kd leaf.png\n");
    folder.write_png("leaf.png", top_left_hole(true));
    const Scene stencil = folder.load("a.obj", kLeaf);
    EXPECT_TRUE(material_of(stencil).is_cutout());
    EXPECT_THAT(warnings_of(stencil), HasSubstr("leaf.png: its alpha cuts holes"));
    Image<glm::u8vec4> gloss(16, 16);
    for (int i = 0; i < 256; ++i) gloss.pixels[static_cast<std::size_t>(i)] = glm::u8vec4(200, 200, 200, i);
    folder.write_png("leaf.png", gloss);
    const Scene solid = folder.load("a.obj", kLeaf);
    EXPECT_FALSE(material_of(solid).is_cutout());
    EXPECT_THAT(warnings_of(solid), HasSubstr("drawn solid"));
}

TEST(Cutouts, OfAPlyComeFromItsOneTextureByVerticesOrByCornersOfFaces) {
    const ImportFolder folder;
    folder.write_png("leaf.png", top_left_hole(true));
    const std::string start =
        "ply\nformat ascii 1.0\ncomment TextureFile leaf.png\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\n";
    const std::string by_vertex =
        "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n"
        "end_header\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n";
    const std::string by_corner =
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 8 0 0 1 0 1 1 0 1\n";
    for (const std::string& rest : {by_vertex, by_corner}) {
        const Scene scene = folder.load("a.ply", start + rest);
        EXPECT_TRUE(material_of(scene).is_cutout());
        const glm::vec2 top_left = texcoord_at(scene, {0, 1, 0}), top_right = texcoord_at(scene, {1, 1, 0});
        const glm::vec2 bottom_left = texcoord_at(scene, {0, 0, 0}),
                        middle = (bottom_left + top_right) / 2.0f;
        EXPECT_EQ(alpha_of(scene, glm::mix(top_left, middle, 0.5f)), 0.0f);
        EXPECT_EQ(alpha_of(scene, glm::mix(bottom_left, middle, 0.5f)), 1.0f);
    }
}

TEST(Cutouts, FindImagesByTheNamesOfOtherMachines) {
    for (const char* name : {"Textures\\Mask.PNG", "C:\\Users\\me\\scene\\textures\\mask.png",
                             "../textures/mask.png", "/home/me/mask.png", "-clamp on textures/mask.png"}) {
        const ImportFolder folder;
        folder.write("a.mtl", std::string("newmtl leaf\r\nmap_d ") + name + "\r\n");
        folder.write_png("textures/mask.png", top_left_hole(false));
        EXPECT_TRUE(material_of(folder.load("a.obj", kLeaf)).is_cutout()) << name;
    }
}

TEST(Cutouts, OfLessThanHalfOpaqueMaterialsAreWholeSurfacesAndSaidSo) {
    const ImportFolder folder;
    folder.write("a.mtl", "newmtl wall\nd 1\nnewmtl leaf\nd 0.25\n");
    const Scene scene = folder.load("a.obj", kLeaf);
    EXPECT_TRUE(material_of(scene).is_cutout());
    EXPECT_EQ(alpha_of(scene, {0, 0}), 0.25f);
    EXPECT_THAT(warnings_of(scene), HasSubstr("material leaf has an opacity of 0.25"));
    folder.write("a.mtl", "newmtl wall\nTr 1\nnewmtl leaf\nTr 1\n");
    const Scene distrusted = folder.load("a.obj", kLeaf);
    EXPECT_FALSE(material_of(distrusted).is_cutout());
    EXPECT_THAT(warnings_of(distrusted), HasSubstr("every material is less than half opaque"));
}

TEST(Cutouts, ThatCannotBeReadAreNamed) {
    const ImportFolder folder;
    EXPECT_THAT(warnings_of(folder.load("a.obj", kLeaf)), HasSubstr("material library a.mtl is not in"));
    folder.write("a.mtl", "newmtl leaf\nmap_d gone.png\n");
    EXPECT_THAT(warnings_of(folder.load("a.obj", kLeaf)), HasSubstr("material leaf is drawn solid"));
    folder.write("a.mtl", "newmtl leaf\nmap_d broken.png\n");
    folder.write("broken.png", "\x89PNG\r\n\x1a\nnot really");
    EXPECT_THAT(warnings_of(folder.load("a.obj", kLeaf)), HasSubstr("image broken.png is broken"));
    folder.write("a.mtl", "newmtl other\n");
    EXPECT_THAT(warnings_of(folder.load("a.obj", kLeaf)), HasSubstr("in no library, such as leaf"));
}

TEST(Cutouts, NeverComeFromOutsideTheScenesFolder) {
    const ImportFolder folder;
    folder.write("outside.mtl", "newmtl leaf\nd 0.1\n");
    std::filesystem::create_directories(folder.path() / "in");
    std::filesystem::create_symlink("../outside.mtl", folder.path() / "in" / "link.mtl");
    ASSERT_EQ(mkfifo((folder.path() / "in" / "fifo.mtl").c_str(), 0600), 0);
    for (const std::string library :
         {"../outside.mtl", "link.mtl", "fifo.mtl", "../../../../../../../etc/passwd", "/dev/zero", "."}) {
        const Scene scene = folder.load("in/a.obj", "mtllib " + library + kLeaf.substr(kLeaf.find('\n')));
        EXPECT_FALSE(material_of(scene).is_cutout()) << library;
        EXPECT_THAT(warnings_of(scene), HasSubstr("is not in the scene's folder")) << library;
    }
}

}  // namespace
