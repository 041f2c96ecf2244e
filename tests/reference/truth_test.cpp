#include "reference/truth.h"

#include "core/error.h"
#include "core/threads.h"
#include "reference/estimate/estimate.h"
#include "reference/integrator/tile.h"
#include "reference/test_scenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aoscore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<TruthQuery> kUnlimited = {{Falloff::binary, kInfinity, 0}};

TruthSettings with_samples(int samples, std::uint64_t seed = 1) {
    TruthSettings settings;
    settings.samples = samples;
    settings.seed = seed;
    return settings;
}

const Camera kStillLifeCamera = testing::looking({2, 2, 3}, {0, 0.6, 0});

Truth trace(const Scene& scene, const Camera& camera, int width, int height,
            const std::vector<TruthQuery>& queries, const TruthSettings& settings) {
    return ReferenceScene(scene).trace(CameraFrame(camera, width, height), queries, settings, "test");
}

TEST(Truth, IsTheSameForAnyThreadCount) {
    const Scene scene = testing::still_life();
    const std::vector<TruthQuery> queries = {{Falloff::binary, 0.7, 0}, {Falloff::quadratic, 0.7, 0}};
    set_thread_count(1);
    const Truth one = trace(scene, kStillLifeCamera, 75, 53, queries, with_samples(37));
    set_thread_count(2);
    const Truth two = trace(scene, kStillLifeCamera, 75, 53, queries, with_samples(37));
    set_thread_count(0);
    for (std::size_t q = 0; q < queries.size(); ++q) {
        EXPECT_EQ(one.visibility[q].pixels, two.visibility[q].pixels);
        EXPECT_EQ(one.standard_error[q].pixels, two.standard_error[q].pixels);
    }
    EXPECT_EQ(one.hits.depth.pixels, two.hits.depth.pixels);
    EXPECT_EQ(one.rays, two.rays);
}

TEST(Truth, ChangesWithTheSeedOnly) {
    const Scene scene = testing::still_life();
    const Truth a = trace(scene, kStillLifeCamera, 40, 30, kUnlimited, with_samples(16, 1));
    const Truth b = trace(scene, kStillLifeCamera, 40, 30, kUnlimited, with_samples(16, 1));
    const Truth c = trace(scene, kStillLifeCamera, 40, 30, kUnlimited, with_samples(16, 2));
    EXPECT_EQ(a.visibility[0].pixels, b.visibility[0].pixels);
    EXPECT_NE(a.visibility[0].pixels, c.visibility[0].pixels);
}

TEST(Truth, SaysNothingAboutTheBackground) {
    const Truth truth = trace(testing::still_life(), kStillLifeCamera, 64, 48, kUnlimited, with_samples(8));
    int background = 0;
    for (std::size_t i = 0; i < truth.hits.surface.size(); ++i) {
        if (truth.hits.surface.pixels[i] != 0) {
            EXPECT_GT(truth.standard_error[0].pixels[i], 0);
            EXPECT_GT(truth.hits.depth.pixels[i], 0);
            EXPECT_NEAR(glm::length(truth.hits.normal.pixels[i]), 1, 1e-6);
            continue;
        }
        ++background;
        EXPECT_EQ(truth.visibility[0].pixels[i], 1);
        EXPECT_EQ(truth.standard_error[0].pixels[i], 0);
        EXPECT_EQ(truth.hits.depth.pixels[i], 0);
        EXPECT_EQ(truth.hits.normal.pixels[i], glm::vec3(0));
    }
    EXPECT_GT(background, 50);
    EXPECT_GT(static_cast<int>(truth.hits.surface.size()) - background, 500);
}

TEST(Truth, AnEmptySceneIsAllBackground) {
    const Truth truth = trace(testing::empty_scene(), kStillLifeCamera, 9, 7, kUnlimited, with_samples(8));
    EXPECT_EQ(std::count(truth.hits.surface.pixels.begin(), truth.hits.surface.pixels.end(), 1), 0);
    EXPECT_EQ(truth.rays, 0u);
}

TEST(Truth, SeesOnlyWhatLiesBetweenNearAndFar) {
    Scene scene = testing::empty_scene();
    for (const double z : {-1.0, -2.0, -4.0}) {
        testing::add(scene, testing::quad({-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}));
    }
    Camera camera = testing::looking({0, 0, 0}, {0, 0, -1});
    camera.near = 1.5;
    camera.far = 3;
    const ReferenceScene reference(scene);
    EXPECT_NEAR(reference.primary_hits(CameraFrame(camera, 5, 3)).depth.at(4, 0), 2, 1e-6);
    camera.near = 2.5;
    EXPECT_EQ(reference.primary_hits(CameraFrame(camera, 5, 3)).surface.at(4, 0), 0);
}

TEST(Truth, OrthographicAndPerspectiveCamerasFindTheSurfaceUnderThePixel) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::quad({-50, -3, 50}, {50, 1, 50}, {50, 1, -50}, {-50, -3, -50}));
    const glm::dvec3 n = glm::normalize(glm::cross(glm::dvec3(100, 4, 0), glm::dvec3(0, 0, -100)));
    const ReferenceScene reference(scene);
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
        Camera camera = testing::looking({1, 4, 3}, {0, 0, -1});
        camera.projection = projection;
        camera.half_height = 2;
        const CameraFrame frame(camera, 31, 17);
        const PrimaryHits hits = reference.primary_hits(frame);
        for (int y = 0; y < 17; ++y) {
            for (int x = 0; x < 31; ++x) {
                const CameraFrame::Ray ray = frame.ray(x + 0.5, y + 0.5);
                const double t = glm::dot(n, glm::dvec3(0, -1, 0) - ray.origin) / glm::dot(n, ray.direction);
                ASSERT_NEAR(hits.depth.at(x, y), t, 2e-5 * t);
                const glm::dvec3 world_normal =
                    glm::dmat3(frame.world_from_view()) * glm::dvec3(hits.normal.at(x, y));
                ASSERT_NEAR(glm::distance(world_normal, n), 0, 1e-5);
            }
        }
    }
}

TEST(Truth, SurfacesAreTwoSided) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(5, 2));
    testing::add(scene, testing::quad({-2, 1, -2}, {2, 1, -2}, {2, 1, 2}, {-2, 1, 2}));
    Scene turned = scene;
    for (Mesh& mesh : turned.meshes) {
        for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    }
    const Camera camera = testing::looking({3, 0.7, 0.4}, {0, 0, 0});
    const Truth a = trace(scene, camera, 32, 24, kUnlimited, with_samples(64));
    const Truth b = trace(turned, camera, 32, 24, kUnlimited, with_samples(64));
    EXPECT_EQ(a.hits.normal.pixels, b.hits.normal.pixels);
    EXPECT_EQ(a.visibility[0].pixels, b.visibility[0].pixels);
    EXPECT_LT(*std::min_element(a.visibility[0].pixels.begin(), a.visibility[0].pixels.end()), 0.5f);
}

TEST(Truth, HolesOfCutOutsLetEveryRayThrough) {
    const Camera camera = testing::looking({0.2, 6, 0.3}, {0, 0, 0});
    const auto with_roof = [](Mesh roof, Material material, std::optional<Texture> texture) {
        Scene scene = testing::empty_scene();
        testing::add(scene, testing::floor_grid(5, 2));
        if (texture) scene.textures.push_back(*texture);
        scene.materials.push_back(material);
        roof.material = 1;
        testing::add(scene, std::move(roof));
        return scene;
    };
    Mesh roof = testing::quad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1});
    roof.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

    Material faint;
    faint.base_color.a = 0.3f;
    faint.alpha_cutoff = 0.5f;
    const Truth open = trace(with_roof(roof, faint, {}), camera, 40, 30, kUnlimited, with_samples(32));
    EXPECT_EQ(*std::min_element(open.visibility[0].pixels.begin(), open.visibility[0].pixels.end()), 1.0f);
    EXPECT_NEAR(open.hits.depth.at(20, 15), 6, 0.02);

    // Alpha crosses the cutoff in the middle of the roof: both kinds of rays see one half of it.
    Texture half;
    half.texels = Image<glm::u8vec4>(2, 1, glm::u8vec4(255));
    half.texels.at(0, 0).a = 0;
    half.wrap_s = half.wrap_t = Texture::Wrap::clamp_to_edge;
    Material masked;
    masked.texture = 0;
    masked.alpha_cutoff = 0.5f;
    Mesh right_half = testing::quad({0, 1, -1}, {1, 1, -1}, {1, 1, 1}, {0, 1, 1});
    const Truth cut = trace(with_roof(roof, masked, half), camera, 40, 30, kUnlimited, with_samples(64));
    const Truth cut_near =
        trace(with_roof(roof, masked, half), camera, 40, 30, {{Falloff::quadratic, 2, 0}}, with_samples(64));
    const Truth solid =
        trace(with_roof(right_half, Material{}, {}), camera, 40, 30, kUnlimited, with_samples(64));
    const Truth solid_near = trace(with_roof(right_half, Material{}, {}), camera, 40, 30,
                                   {{Falloff::quadratic, 2, 0}}, with_samples(64));
    int differing = 0;
    float largest = 0, largest_near = 0;
    for (std::size_t i = 0; i < cut.visibility[0].size(); ++i) {
        differing += cut.visibility[0].pixels[i] != solid.visibility[0].pixels[i];
        largest = std::max(largest, std::abs(cut.visibility[0].pixels[i] - solid.visibility[0].pixels[i]));
        largest_near = std::max(
            largest_near, std::abs(cut_near.visibility[0].pixels[i] - solid_near.visibility[0].pixels[i]));
    }
    EXPECT_LE(largest, 1.5f / 64);
    EXPECT_LE(largest_near, 1.5f / 64);
    EXPECT_LE(differing, 12);
}

TEST(Truth, InstancesEqualBakedGeometry) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(4, 3));
    testing::add(scene, testing::sphere({1000, 0, 0}, 0.5, 20));  // far from its own origin
    scene.instances.pop_back();
    for (int i = 0; i < 5; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {0.8 * i - 1.6, 0.6, 0.2 * i});
        m = glm::scale(m, {i == 2 ? -1.0 : 1.0, 1.0 + 0.1 * i, 0.7});
        m = glm::rotate(m, 0.4 * i, glm::dvec3(0, 1, 0));
        scene.instances.push_back({1, m * glm::translate(glm::dmat4(1), {-1000, 0, 0})});
    }
    const CameraFrame frame(testing::looking({2, 3, 4}, {0, 0.3, 0}), 64, 48);
    const Truth baked = ReferenceScene(scene).trace(frame, kUnlimited, with_samples(64), "baked");
    const Truth instanced =
        ReferenceScene(scene, TraceBuild{0}).trace(frame, kUnlimited, with_samples(64), "shared");
    int other_surface = 0, differing = 0;
    for (std::size_t i = 0; i < baked.hits.surface.size(); ++i) {
        const bool same = baked.hits.surface.pixels[i] == instanced.hits.surface.pixels[i] &&
                          std::abs(baked.hits.depth.pixels[i] - instanced.hits.depth.pixels[i]) < 1e-4 &&
                          glm::distance(baked.hits.normal.pixels[i], instanced.hits.normal.pixels[i]) < 1e-2;
        other_surface += !same;
        differing +=
            same && std::abs(baked.visibility[0].pixels[i] - instanced.visibility[0].pixels[i]) > 2.5 / 64;
    }
    EXPECT_LE(other_surface, 3);  // pixels whose centre falls on an edge between facets
    EXPECT_EQ(differing, 0);
    EXPECT_GT(baked.rays, 64u * 1000);
}

/// Visibility of a floor point before an endless wall, by a fine midpoint rule over the projected hemisphere.
double wall_by_quadrature(double distance, double height, const TruthQuery& query) {
    constexpr int kSteps = 1500;
    double open = 0;
    int points = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double x = (2.0 * i + 1) / kSteps - 1, z = (2.0 * j + 1) / kSteps - 1;
            if (x * x + z * z >= 1) continue;
            ++points;
            const double y = std::sqrt(1 - x * x - z * z);
            const double t = distance / -x;
            double g = 0;
            if (x < 0 && t * y <= height && t <= query.radius_m) {
                const double ratio = t / query.radius_m;
                g = query.falloff == Falloff::binary      ? 1
                    : query.falloff == Falloff::quadratic ? 1 - ratio * ratio
                    : query.falloff == Falloff::xegtao    ? std::min(1.0, (1 - ratio) / 0.615)
                    : t > query.u_m                       ? query.u_m / t
                                                          : t / query.u_m;
            }
            open += 1 - g;
        }
    }
    return open / points;
}

TEST(Truth, FalloffsAgreeWithQuadrature) {
    constexpr double kDistance = 0.4, kHeight = 1;
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::quad({-300, 0, 300}, {300, 0, 300}, {300, 0, -300}, {-300, 0, -300}));
    testing::add(scene, testing::quad({0, 0, -300}, {0, kHeight, -300}, {0, kHeight, 300}, {0, 0, 300}));
    const std::vector<TruthQuery> queries = {
        {Falloff::binary, 0.7, 0},    {Falloff::binary, kInfinity, 0},     {Falloff::quadratic, 0.7, 0},
        {Falloff::quadratic, 3, 0},   {Falloff::alchemy, kInfinity, 0.25}, {Falloff::alchemy, kInfinity, 0.9},
        {Falloff::alchemy, 1.1, 0.9}, {Falloff::xegtao, 0.9, 0},           {Falloff::xegtao, 4, 0},
    };
    // Orthographic and narrow: every pixel looks at the same distance from the wall.
    Camera camera = testing::looking({kDistance, 0.5, 0}, {kDistance, 0, 0});
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = 1e-5;
    const Truth truth = trace(scene, camera, 4, 4, queries, with_samples(4096));
    for (std::size_t q = 0; q < queries.size(); ++q) {
        const double expected = wall_by_quadrature(kDistance, kHeight, queries[q]);
        double mean = 0, variance = 0;
        for (std::size_t i = 0; i < 16; ++i) {
            mean += truth.visibility[q].pixels[i] / 16.0;
            variance += std::pow(truth.standard_error[q].pixels[i] / 16.0, 2);
        }
        EXPECT_NEAR(mean, expected, 3 * std::sqrt(variance) + 1e-5) << "query " << q;
        EXPECT_LT(std::sqrt(variance), 1e-3);
    }
}

TEST(Truth, OneRadiusAloneEqualsThatRadiusAmongOthers) {
    const Scene scene = testing::still_life();
    const Truth alone = trace(scene, kStillLifeCamera, 64, 48, {{Falloff::binary, 0.5, 0}}, with_samples(64));
    const Truth among = trace(
        scene, kStillLifeCamera, 64, 48,
        {{Falloff::quadratic, 2, 0}, {Falloff::binary, 0.5, 0}, {Falloff::binary, 2, 0}}, with_samples(64));
    for (std::size_t i = 0; i < alone.visibility[0].size(); ++i) {
        EXPECT_NEAR(alone.visibility[0].pixels[i], among.visibility[1].pixels[i], 1.01 / 64);
        EXPECT_LE(among.visibility[2].pixels[i], among.visibility[1].pixels[i]);
        EXPECT_LE(among.visibility[2].pixels[i], among.visibility[0].pixels[i]);
    }
}

TEST(Truth, ShadingNormalsTurnTheHemisphere) {
    Scene scene = testing::empty_scene();
    Mesh floor = testing::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9});
    testing::add(scene, floor);
    scene.meshes[0].normals.assign(4, glm::vec3(glm::normalize(glm::dvec3(1, 1, 0))));
    TruthSettings settings = with_samples(4096);
    const Camera camera = testing::looking({0, 3, 0.1}, {0, 0, 0});
    EXPECT_EQ(trace(scene, camera, 3, 3, kUnlimited, settings).visibility[0].at(1, 1), 1.0f);
    settings.shading_normals = true;
    // The part of the tilted hemisphere below the floor is blocked: V = (1 + cos tilt) / 2.
    EXPECT_NEAR(trace(scene, camera, 3, 3, kUnlimited, settings).visibility[0].at(1, 1),
                (1 + std::sqrt(0.5)) / 2, 0.003);
}

TEST(Truth, AnySampleCountGivesFiniteHonestNumbers) {
    const Scene scene = testing::still_life();
    constexpr int kPixels = kTileSide * kTileSide;
    for (const int samples : {1, 2, 3, 5, 7, 64, 101}) {
        const Truth truth = trace(scene, kStillLifeCamera, 24, 18, kUnlimited, with_samples(samples));
        EXPECT_EQ(truth.samples, samples);
        for (std::size_t i = 0; i < truth.visibility[0].size(); ++i) {
            const float v = truth.visibility[0].pixels[i], se = truth.standard_error[0].pixels[i];
            ASSERT_TRUE(v >= 0 && v <= 1);
            if (truth.hits.surface.pixels[i] == 0) continue;
            ASSERT_GE(se, static_cast<float>(error_of_agreement(samples, kPixels, kPixels)));
            ASSERT_LE(se, 0.5f + 1e-6f);
        }
    }
}

TEST(Truth, RefusesSettingsThatMakeNoSense) {
    const Scene scene = testing::still_life();
    const auto attempt = [&](const std::vector<TruthQuery>& queries, int samples) {
        return trace(scene, kStillLifeCamera, 4, 4, queries, with_samples(samples));
    };
    EXPECT_THROW(attempt(kUnlimited, 0), Error);
    EXPECT_THROW(attempt({}, 4), Error);
    EXPECT_THROW(attempt({{Falloff::binary, 0, 0}}, 4), Error);
    EXPECT_THROW(attempt({{Falloff::binary, std::nan(""), 0}}, 4), Error);
    EXPECT_THROW(attempt({{Falloff::alchemy, kInfinity, 0}}, 4), Error);
}

}  // namespace
}  // namespace aoscore
