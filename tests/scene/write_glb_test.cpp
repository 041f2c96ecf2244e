// Scenes that are written for other programs.
#include "scene/gltf/write_glb.h"

#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

using testing::output_dir;

double farthest(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b);
}

/// A triangle of the scene: its corners, and the normals there.
using PlacedTriangle = std::array<std::array<double, 3>, 6>;

/// All triangles in scene space, sorted: readers may number vertices and meshes anew.
std::vector<PlacedTriangle> triangles_of(const Scene& scene) {
    std::vector<PlacedTriangle> triangles;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const glm::uvec3& triangle : mesh.triangles) {
            PlacedTriangle placed{};
            for (int corner = 0; corner < 3; ++corner) {
                const auto vertex = triangle[corner];
                const glm::dvec4 p = instance.scene_from_mesh * glm::dvec4(mesh.positions[vertex], 1);
                placed[static_cast<std::size_t>(corner)] = {p.x, p.y, p.z};
                if (mesh.normals.empty()) continue;
                const glm::vec3& n = mesh.normals[vertex];
                placed[static_cast<std::size_t>(corner) + 3] = {n.x, n.y, n.z};
            }
            triangles.push_back(placed);
        }
    }
    std::ranges::sort(triangles);
    return triangles;
}

// Positions are the same to the bit; normals are made unit again when they are read.
TEST(WrittenScene, IsTheSameSceneWhenItIsRead) {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        SCOPED_TRACE(builtin.id);
        const Scene scene = load_scene(std::string(builtin.id));
        const auto file = output_dir() / (std::string(builtin.id) + ".glb");
        write_glb(scene, file);
        const Scene read = load_scene(file.string());
        EXPECT_LT(farthest(read.bounds.low, scene.bounds.low), 1e-9);
        EXPECT_LT(farthest(read.bounds.high, scene.bounds.high), 1e-9);
        const std::vector<PlacedTriangle> before = triangles_of(scene), after = triangles_of(read);
        ASSERT_EQ(after.size(), before.size());
        std::size_t moved = 0, turned = 0;
        for (std::size_t t = 0; t < before.size(); ++t) {
            for (std::size_t corner = 0; corner < 6; ++corner) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double apart = std::abs(after[t][corner][axis] - before[t][corner][axis]);
                    moved += corner < 3 && apart > 0;
                    turned += corner >= 3 && apart > 1e-6;
                }
            }
        }
        EXPECT_EQ(moved, 0U);
        EXPECT_EQ(turned, 0U);
    }
}

TEST(WrittenScene, KeepsTheHolesOfCutOuts) {
    Scene scene = load_scene("wall");
    Texture texture;
    texture.texels = Image<glm::u8vec4>(4, 2, glm::u8vec4(200, 100, 50, 255));
    texture.texels.at(1, 0).a = 0;
    texture.texels.at(3, 1).a = 90;
    texture.wrap_s = Texture::Wrap::mirrored_repeat;
    texture.wrap_t = Texture::Wrap::clamp_to_edge;
    scene.textures = {texture};
    Material& material = scene.materials[static_cast<std::size_t>(scene.meshes[0].material)];
    material.texture = 0;
    material.alpha_cutoff = 0.4F;
    scene.meshes[0].texcoords.assign(scene.meshes[0].positions.size(), glm::vec2(0.3F, 0.6F));
    const auto file = output_dir() / "cutout.glb";
    write_glb(scene, file);
    const Scene read = load_scene(file.string());
    ASSERT_EQ(read.textures.size(), 1U);
    ASSERT_TRUE(read.textures[0].texels.same_size(texture.texels));
    for (std::size_t i = 0; i < texture.texels.size(); ++i)
        EXPECT_EQ(read.textures[0].texels.pixels[i].a, texture.texels.pixels[i].a) << i;
    EXPECT_EQ(read.textures[0].wrap_s, texture.wrap_s);
    EXPECT_EQ(read.textures[0].wrap_t, texture.wrap_t);
    const Material& kept = read.materials[static_cast<std::size_t>(read.meshes[0].material)];
    EXPECT_FLOAT_EQ(kept.alpha_cutoff, 0.4F);
    EXPECT_EQ(read.meshes[0].texcoords, scene.meshes[0].texcoords);
}

}  // namespace
}  // namespace aoscore
