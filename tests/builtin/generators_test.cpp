#include "builtin_table.h"
#include "scene/scene.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

namespace aoscore {
namespace {

using testing::EveryBuiltin;

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(BuiltinTable, HasTheNamedScenes) {
    std::vector<std::string> ids;
    for (const BuiltinScene& scene : builtin_scenes()) {
        ids.emplace_back(scene.id);
        EXPECT_FALSE(scene.description.empty()) << scene.id;
    }
    EXPECT_THAT(ids, ::testing::UnorderedElementsAre("atrium", "cathedral", "pillar", "plane", "wall",
                                                     "wall_tall", "sphere", "pit", "railing", "yard",
                                                     "layers", "grazing", "vault", "hairball", "courtyard"));
}

TEST_P(EveryBuiltin, IsTheSameEachTime) {
    const Scene a = GetParam().generate(), b = GetParam().generate();
    ASSERT_EQ(a.meshes.size(), b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        EXPECT_TRUE(same_bytes(a.meshes[i].positions, b.meshes[i].positions)) << "mesh " << i;
        EXPECT_TRUE(same_bytes(a.meshes[i].normals, b.meshes[i].normals)) << "mesh " << i;
        EXPECT_TRUE(same_bytes(a.meshes[i].texcoords, b.meshes[i].texcoords)) << "mesh " << i;
        EXPECT_TRUE(same_bytes(a.meshes[i].triangles, b.meshes[i].triangles)) << "mesh " << i;
    }
    ASSERT_EQ(a.instances.size(), b.instances.size());
    for (std::size_t i = 0; i < a.instances.size(); ++i) {
        EXPECT_EQ(a.instances[i].mesh, b.instances[i].mesh);
        EXPECT_EQ(a.instances[i].scene_from_mesh, b.instances[i].scene_from_mesh);
    }
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t i = 0; i < a.textures.size(); ++i) {
        EXPECT_TRUE(same_bytes(a.textures[i].texels.pixels, b.textures[i].texels.pixels));
    }
}

TEST_P(EveryBuiltin, HasIndicesInRangeAndFiniteUnitVectors) {
    const Scene scene = GetParam().generate();
    ASSERT_FALSE(scene.instances.empty());
    ASSERT_FALSE(scene.materials.empty());
    for (const Instance& instance : scene.instances) {
        ASSERT_GE(instance.mesh, 0);
        ASSERT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size());
        EXPECT_GT(glm::determinant(glm::dmat3(instance.scene_from_mesh)), 0) << "turned inside out";
    }
    for (const Mesh& mesh : scene.meshes) {
        ASSERT_FALSE(mesh.triangles.empty());
        ASSERT_GE(mesh.material, 0);
        ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size());
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        ASSERT_LT(material.texture, static_cast<int>(scene.textures.size()));
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        ASSERT_EQ(mesh.texcoords.size(), material.texture >= 0 ? mesh.positions.size() : 0);
        for (const glm::vec3& p : mesh.positions) ASSERT_TRUE(finite(p));
        for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1, 1e-5);
        for (const glm::uvec3& t : mesh.triangles) {
            ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        }
    }
}

TEST_P(EveryBuiltin, HasNoTriangleWithoutArea) {
    const Scene scene = GetParam().generate();
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const glm::uvec3& t : mesh.triangles) {
            glm::dvec3 p[3];
            for (int k = 0; k < 3; ++k) {
                p[k] = glm::vec3(instance.scene_from_mesh * glm::dvec4(mesh.positions[t[k]], 1));
            }
            const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2;
            ASSERT_GT(area, 1e-8) << "mesh " << instance.mesh;
        }
    }
}

TEST_P(EveryBuiltin, HasSmoothNormalsOnTheSideOfTheWinding) {
    const Scene scene = GetParam().generate();
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 flat =
                triangle_normal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
            for (int k = 0; k < 3; ++k) {
                ASSERT_GT(glm::dot(flat, glm::dvec3(mesh.normals[t[k]])), 0.5) << "mesh " << i;
            }
        }
    }
}

std::size_t triangles_in_scene(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& i : scene.instances)
        count += scene.meshes[static_cast<std::size_t>(i.mesh)].triangles.size();
    return count;
}

TEST(Atrium, HasAboutAQuarterMillionTrianglesMostlyInstanced) {
    const Scene scene = load_scene("atrium");
    EXPECT_GE(scene.triangle_count, 225'000u);
    EXPECT_LE(scene.triangle_count, 275'000u);
    EXPECT_EQ(scene.triangle_count, triangles_in_scene(scene));
    std::size_t stored = 0;
    for (const Mesh& mesh : scene.meshes) stored += mesh.triangles.size();
    EXPECT_LT(stored, scene.triangle_count / 2);
}

TEST(Atrium, HasLeavesCutOutOfCards) {
    const Scene scene = load_scene("atrium");
    int cards = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        if (!material.is_cutout()) continue;
        ++cards;
        EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.5f);
    }
    EXPECT_GT(cards, 100);
    ASSERT_EQ(scene.textures.size(), 1u);
    int solid = 0, hole = 0;
    const Image<glm::u8vec4>& texels = scene.textures[0].texels;
    for (const glm::u8vec4& texel : texels.pixels) (texel.a >= 128 ? solid : hole) += 1;
    EXPECT_GT(solid, static_cast<int>(texels.size()) / 5);
    EXPECT_GT(hole, static_cast<int>(texels.size()) / 5);
}

TEST(Cathedral, HasTheSizeOfItsModel) {
    const Scene scene = load_scene("cathedral");
    EXPECT_GE(scene.triangle_count, 80'000u);
    EXPECT_LE(scene.triangle_count, 160'000u);
    const glm::dvec3 size = scene.bounds.high - scene.bounds.low;
    EXPECT_NEAR(size.x, 45, 10);
    EXPECT_NEAR(size.z, 20, 5);
}

AOSCORE_FOR_EVERY_BUILTIN(EveryBuiltin);

}  // namespace
}  // namespace aoscore
