// Tests the depths that a ray through a pixel gathers, behind walls that fill the picture one after the
// other.
#include "reference/ray_layers.h"

#include "core/threads.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace aoscore {
namespace {

constexpr int kWalls = 6, kSide = 96;
constexpr double kNearest = 5, kFar = 100;

double depth_of_wall(int wall) {
    return kNearest + wall;
}

Scene walls() {
    Scene scene = testing::empty_scene();
    for (int i = 0; i < kWalls; ++i) {
        const double z = -depth_of_wall(i), h = 40;
        testing::add(scene, testing::quad({-h, -h, z}, {h, -h, z}, {h, h, z}, {-h, h, z}));
    }
    return scene;
}

CameraFrame front() {
    Camera camera;
    camera.far = kFar;
    return {camera, kSide, kSide};
}

std::vector<ImageF> layers_of(const RayLayers& wanted) {
    return ReferenceScene(walls()).ray_layers(front(), wanted);
}

/// The number of the wall at this depth, -1 for none.
int wall_at(float depth) {
    for (int wall = 0; wall < kWalls; ++wall) {
        if (std::abs(static_cast<double>(depth) - depth_of_wall(wall)) < 1e-4) return wall;
    }
    EXPECT_EQ(depth, static_cast<float>(kFar)) << "neither a wall nor the far plane";
    return -1;
}

TEST(RayLayers, AreAllSurfacesFromFrontToBackWhereThereIsRoom) {
    const std::vector<ImageF> layers = layers_of({.samples = kWalls + 2});
    for (int sample = 0; sample < kWalls + 2; ++sample) {
        for (const float depth : layers[static_cast<std::size_t>(sample)].pixels)
            ASSERT_EQ(wall_at(depth), sample < kWalls ? sample : -1);
    }
}

// Two of the five behind the first: each in two of five pixels, and no wall twice in one.
TEST(RayLayers, HoldEachSurfaceBehindTheFirstWithTheSameProbability) {
    constexpr double kPixels = kSide * kSide, kShare = 2.0 / (kWalls - 1);
    for (const std::uint32_t seed : {1u, 2u}) {
        const std::vector<ImageF> layers = layers_of({.samples = 3, .seed = seed});
        std::array<int, kWalls> held{};
        for (std::size_t i = 0; i < layers[0].size(); ++i) {
            const int first = wall_at(layers[0].pixels[i]), one = wall_at(layers[1].pixels[i]),
                      other = wall_at(layers[2].pixels[i]);
            ASSERT_EQ(first, 0);
            ASSERT_NE(one, other);
            ++held[static_cast<std::size_t>(one)];
            ++held[static_cast<std::size_t>(other)];
        }
        for (int wall = 1; wall < kWalls; ++wall) {
            EXPECT_NEAR(held[static_cast<std::size_t>(wall)] / kPixels, kShare,
                        5 * std::sqrt(kShare * (1 - kShare) / kPixels))
                << "wall " << wall << ", seed " << seed;
        }
    }
}

TEST(RayLayers, OfOtherSeedsAreOthers) {
    const std::vector<ImageF> a = layers_of({.samples = 2, .seed = 1}),
                              b = layers_of({.samples = 2, .seed = 2});
    std::size_t same = 0;
    for (std::size_t i = 0; i < a[1].size(); ++i) same += a[1].pixels[i] == b[1].pixels[i] ? 1 : 0;
    const double pixels = kSide * kSide;
    EXPECT_NEAR(static_cast<double>(same) / pixels, 1.0 / (kWalls - 1), 5 * std::sqrt(0.16 / pixels));
}

TEST(RayLayers, LieWithinTheirReachBehindTheFirst) {
    const std::vector<ImageF> layers = layers_of({.samples = kWalls, .reach_m = 2.5});
    for (int sample = 0; sample < kWalls; ++sample) {
        for (const float depth : layers[static_cast<std::size_t>(sample)].pixels)
            ASSERT_EQ(wall_at(depth), sample <= 2 ? sample : -1);
    }
}

TEST(RayLayers, AreLookedForAmongTheNearestAlone) {
    const std::vector<ImageF> layers = layers_of({.samples = 2, .most_behind = 3});
    for (const float depth : layers[1].pixels) {
        ASSERT_GE(wall_at(depth), 1);
        ASSERT_LE(wall_at(depth), 3);
    }
}

TEST(RayLayers, DoNotDependOnTheNumberOfThreads) {
    set_thread_count(1);
    const std::vector<ImageF> one = layers_of({.samples = 4});
    set_thread_count(0);
    const std::vector<ImageF> all = layers_of({.samples = 4});
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].pixels, all[i].pixels);
}

}  // namespace
}  // namespace aoscore
