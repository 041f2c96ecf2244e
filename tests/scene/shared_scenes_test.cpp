#include "gltf_file.h"
#include "scene/scene.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace {

using aoscore::Scene;
using aoscore::testing::all_corners;
using aoscore::testing::has_warning;

Scene load(const std::string& file) {
    return aoscore::load_scene((aoscore::testing::shared_dir() / "scenes" / file).string());
}

/// The first of the file's own cameras, whatever view files come before it.
const aoscore::Camera& own_camera(const Scene& scene) {
    return std::find_if(scene.views.begin(), scene.views.end(),
                        [](const auto& view) { return view.source.starts_with("camera node "); })
        ->camera;
}

/// Compares corner by corner after `move`, in shares of the first scene's diagonal.
void expect_same_shape(const Scene& a, const Scene& b, double tolerance,
                       glm::dvec3 (*move)(const glm::dvec3&)) {
    const auto corners_a = all_corners(a), corners_b = all_corners(b);
    ASSERT_EQ(corners_a.size(), corners_b.size());
    double worst = 0;
    for (std::size_t i = 0; i < corners_a.size(); ++i) {
        worst = std::max(worst, glm::distance(move(corners_a[i] + a.origin), corners_b[i] + b.origin));
    }
    EXPECT_LE(worst, tolerance * b.bounds.diagonal());
}
glm::dvec3 stay(const glm::dvec3& p) {
    return p;
}

TEST(SharedScenes, HaveTheTrianglesAndCamerasOfTheirReadme) {
    REQUIRE_SHARED_INPUTS();
    struct Expected {
        const char* file;
        std::size_t triangles;
        std::size_t degenerate;
        std::size_t cameras;
    };
    for (const Expected& e : {Expected{"sponza_crytek.glb", 262267, 0, 4},
                              {"sibenik.glb", 73564, 8, 3},
                              {"fireplace_room.glb", 105299, 190, 1},
                              {"staircase.glb", 30911, 2432, 1},
                              {"cornell_original.glb", 36, 0, 1},
                              {"stanford_group.glb", 269579, 0, 2},
                              {"hairball_synthetic.glb", 307200, 0, 2},
                              {"flight_helmet.glb", 94722, 0, 2}}) {
        const Scene scene = load(e.file);
        EXPECT_EQ(scene.triangle_count + e.degenerate, e.triangles) << e.file;
        EXPECT_EQ(has_warning(scene, std::to_string(e.degenerate) + " triangles without area"),
                  e.degenerate > 0)
            << e.file;
        const auto cameras = std::count_if(scene.views.begin(), scene.views.end(), [](const auto& view) {
            return view.source.starts_with("camera node ");
        });
        EXPECT_EQ(static_cast<std::size_t>(cameras), e.cameras) << e.file;
        EXPECT_EQ(scene.origin, glm::dvec3(0.0)) << e.file;
    }
}

TEST(SharedScenes, SponzasLeavesAreCutOut) {
    REQUIRE_SHARED_INPUTS();
    const Scene scene = load("sponza_crytek.glb");
    std::size_t triangles = 0;
    for (const auto& mesh : scene.meshes) {
        const auto& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        if (!material.is_cutout()) continue;
        triangles += mesh.triangles.size();
        ASSERT_EQ(mesh.texcoords.size(), mesh.positions.size());
        ASSERT_GE(material.texture, 0);
    }
    EXPECT_EQ(triangles, 34940u);
}

TEST(SharedScenes, SibenikHasFlatNormals) {
    REQUIRE_SHARED_INPUTS();
    for (const auto& mesh : load("sibenik.glb").meshes) EXPECT_TRUE(mesh.normals.empty());
}

TEST(Variants, InterleavedIsTheOriginal) {
    REQUIRE_SHARED_INPUTS();
    EXPECT_EQ(load("variants/stanford_group.interleaved.glb").digest, load("stanford_group.glb").digest);
}

TEST(Variants, MirroredIsTheMirrorImage) {
    REQUIRE_SHARED_INPUTS();
    const Scene original = load("stanford_group.glb"), mirrored = load("variants/stanford_group.mirror.glb");
    const glm::dvec3 flip = own_camera(mirrored).position / own_camera(original).position;
    EXPECT_NEAR(flip.x * flip.y * flip.z, -1, 1e-6);
    const auto a = all_corners(original), b = all_corners(mirrored);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT(glm::distance(a[i] * glm::round(flip), b[i]), 1e-6);
}

TEST(Variants, QuantisedIsTheOriginalWithinQuantisation) {
    REQUIRE_SHARED_INPUTS();
    // The file has 14 bits over each mesh's own extent.
    expect_same_shape(load("stanford_group.glb"), load("variants/stanford_group.quantized.glb"), 1.0 / 16383,
                      stay);
    expect_same_shape(load("sponza_crytek.glb"), load("variants/sponza_crytek.quantized.glb"), 1.0 / 16383,
                      stay);
}

TEST(Variants, ZUpRootGivesTheOriginal) {
    REQUIRE_SHARED_INPUTS();
    const Scene original = load("staircase.glb"), turned = load("variants/staircase.zup.glb");
    const double diagonal = original.bounds.diagonal();
    EXPECT_NEAR(turned.bounds.diagonal(), diagonal, 1e-5 * diagonal);
    EXPECT_EQ(turned.triangle_count, original.triangle_count);
    // Both cameras see the same: they bring the scene's corners to one view space.
    const aoscore::CameraFrame a(own_camera(original), 160, 90), b(own_camera(turned), 160, 90);
    const auto corners_a = all_corners(original), corners_b = all_corners(turned);
    ASSERT_EQ(corners_a.size(), corners_b.size());
    for (std::size_t i = 0; i < corners_a.size(); ++i) {
        const auto in_a = a.view_from_world() * glm::dvec4(corners_a[i], 1);
        const auto in_b = b.view_from_world() * glm::dvec4(corners_b[i], 1);
        ASSERT_LT(glm::length(in_a - in_b), 1e-5 * diagonal);
    }
}

TEST(Variants, BakedOffsetSurvivesWithinTheStepOfItsFloats) {
    REQUIRE_SHARED_INPUTS();
    const Scene original = load("sibenik.glb"), far = load("variants/sibenik.baked_offset_1e6.glb");
    EXPECT_GT(glm::length(far.origin), 1e5);
    EXPECT_LT(glm::length(far.bounds.centre()), far.bounds.diagonal());
    const glm::dvec3 offset =
        glm::round((far.origin + far.bounds.centre() - original.bounds.centre()) / 1e6) * 1e6;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(far.origin[axis] + far.bounds.low[axis] - offset[axis], original.bounds.low[axis],
                    1.0 / 16);
        EXPECT_NEAR(far.origin[axis] + far.bounds.high[axis] - offset[axis], original.bounds.high[axis],
                    1.0 / 16);
    }
    EXPECT_GT(far.triangle_count, original.triangle_count * 8 / 10);
    // The view is the original's: cameras moved with the scene.
    const auto& a = own_camera(original);
    const auto& b = own_camera(far);
    EXPECT_LT(glm::distance(a.position, b.position + far.origin - offset), 0.1);
    for (const auto& mesh : far.meshes) {
        for (const auto& p : mesh.positions) ASSERT_LT(glm::length(p), 100.0f);
    }
}

TEST(Variants, TinyAndStretchedOnesKeepEveryTriangle) {
    REQUIRE_SHARED_INPUTS();
    const Scene tiny = load("variants/cornell_original.tiny_1e-4.glb");
    EXPECT_EQ(tiny.triangle_count, 36u);
    EXPECT_LT(tiny.bounds.diagonal(), 1e-3);
    EXPECT_LT(own_camera(tiny).far / own_camera(tiny).near, 1.1e5);
    EXPECT_EQ(load("variants/sibenik.nonuniform.glb").triangle_count, load("sibenik.glb").triangle_count);
}

TEST(Variants, WebPCutOutsEqualTheOriginals) {
    REQUIRE_SHARED_INPUTS();
    const Scene png = load("features/GlassVaseFlowers_mask.glb"),
                webp = load("variants/GlassVaseFlowers_mask.webp.glb");
    EXPECT_TRUE(webp.warnings == png.warnings);
    ASSERT_EQ(webp.textures.size(), png.textures.size());
    ASSERT_FALSE(png.textures.empty());
    EXPECT_TRUE(webp.textures[0].texels.same_size(png.textures[0].texels));
}

/// Compares the least and largest of all corners, in shares of the diagonal of `b`.
void expect_same_bounds(const Scene& a, const Scene& b, double tolerance) {
    EXPECT_LE(glm::distance(a.bounds.low, b.bounds.low), tolerance * b.bounds.diagonal());
    EXPECT_LE(glm::distance(a.bounds.high, b.bounds.high), tolerance * b.bounds.diagonal());
}

TEST(Variants, DracoAndMeshoptGiveTheOriginalsBounds) {
    REQUIRE_SHARED_INPUTS();
    const Scene draco = load("variants/sibenik.draco.glb"), sibenik = load("sibenik.glb");
    expect_same_bounds(draco, sibenik, 1.0 / 2048);
    EXPECT_NEAR(static_cast<double>(draco.triangle_count), static_cast<double>(sibenik.triangle_count),
                0.01 * static_cast<double>(sibenik.triangle_count));
    const Scene meshopt = load("variants/fireplace_room.gltfpack_instanced.glb");
    expect_same_bounds(meshopt, load("fireplace_room.glb"), 1.0 / 2048);
}

TEST(Scenes, EveryFileLoadsAndWarnsOfNothingThatIsRead) {
    REQUIRE_SHARED_INPUTS();
    const auto folder = aoscore::testing::shared_dir() / "scenes";
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".glb" && entry.path().extension() != ".gltf") continue;
        const Scene scene = aoscore::load_scene(entry.path().string());
        EXPECT_GT(scene.triangle_count, 0u) << entry.path();
        EXPECT_FALSE(has_warning(scene, "skin")) << entry.path();
        EXPECT_FALSE(has_warning(scene, "not read")) << entry.path();
        EXPECT_FALSE(has_warning(scene, "unknown")) << entry.path();
        ++files;
    }
    EXPECT_GE(files, 40);
}

TEST(Features, CutOutsInAFormatThatIsNotDecodedAreNamed) {
    REQUIRE_SHARED_INPUTS();
    const Scene scene = load("features/StainedGlassLamp-glTF-KTX-BasisU/StainedGlassLamp.gltf");
    EXPECT_TRUE(has_warning(scene, "KTX2 (Basis Universal), which is not decoded here"));
    EXPECT_TRUE(has_warning(load("features/MultipleScenes-glTF/MultipleScenes.gltf"), "scenes[1] of 2"));
}

TEST(Features, NegativeScalesMirrorTheirInstances) {
    REQUIRE_SHARED_INPUTS();
    const Scene scene = load("features/NegativeScaleTest.glb");
    EXPECT_TRUE(std::any_of(scene.instances.begin(), scene.instances.end(), [](const auto& instance) {
        return glm::determinant(instance.scene_from_mesh) < 0;
    }));
}

TEST(Features, SparseAccessorMovesThreeVertices) {
    REQUIRE_SHARED_INPUTS();
    // Khronos' sample is a band of height 1 whose upper middle vertices are lifted to 2, 3 and 4.
    const Scene scene = load("features/SimpleSparseAccessor-glTF/SimpleSparseAccessor.gltf");
    EXPECT_NEAR(scene.bounds.high.y, 4, 1e-6);
}

}  // namespace
