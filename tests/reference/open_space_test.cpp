#include "reference/tracer/open_space.h"

#include "core/sampling.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

/// Boxes of random size, place and orientation about a floor, shared by instances.
Scene random_boxes(std::uint64_t seed) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(6, 4));
    testing::add(scene, testing::sphere({0, 0, 0}, 1, 2));
    scene.instances.pop_back();
    auto random = [state = seed * 1000]() mutable {
        return static_cast<double>(mix_bits(state++) >> 11) * 0x1p-53 * 2 - 1;
    };
    for (int i = 0; i < 12; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), {4 * random(), 1 + random(), 4 * random()});
        m = glm::rotate(m, 3 * random(), glm::normalize(glm::dvec3(random(), random(), 1.5)));
        m = glm::scale(m, {0.4 + 0.3 * random(), 0.4 + 0.3 * random(), 0.4 + 0.3 * random()});
        scene.instances.push_back({1, m});
    }
    return scene;
}

TEST(OpenSpace, WhatIsSkippedWouldHaveBeenOpen) {
    int skipped = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Scene scene = random_boxes(seed);
        for (const TraceBuild build : {TraceBuild{}, TraceBuild{0}}) {
            const ReferenceScene reference(scene, build);
            const CameraFrame frame(testing::looking({5, 4, 6}, {0, 0.3, 0}, 0.9), 96, 72);
            for (const double radius_m : {0.3, 1.0, static_cast<double>(INFINITY)}) {
                TruthSettings settings;
                settings.samples = 256;
                const std::vector<TruthQuery> queries = {{Falloff::binary, radius_m, 0}};
                const Truth with = reference.trace(frame, queries, settings, "skipping");
                settings.skip_open = false;
                const Truth without = reference.trace(frame, queries, settings, "tracing");
                std::uint64_t proven = 0, differing = 0;
                for (std::size_t i = 0; i < with.visibility[0].size(); ++i) {
                    proven += with.standard_error[0].pixels[i] == kProvenError;
                    differing += with.visibility[0].pixels[i] != without.visibility[0].pixels[i];
                }
                EXPECT_EQ(differing, 0u);
                EXPECT_EQ(proven, with.open_pixels);
                EXPECT_EQ(with.rays + 256 * proven, without.rays);
                EXPECT_EQ(without.open_pixels, 0u);
                skipped += static_cast<int>(proven);
            }
        }
    }
    EXPECT_GT(skipped, 20000);
}

TEST(OpenSpace, ProvesMostOfWhatIsOpen) {
    // On a floor with one box, everything far from the box is proven open.
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(5, 4));
    testing::add(scene, testing::sphere({0, 0.5, 0}, 0.5, 6));
    const ReferenceScene reference(scene);
    const CameraFrame frame(testing::looking({4, 5, 4}, {0, 0, 0}, 0.8), 64, 48);
    const Truth truth = reference.trace(frame, {{Falloff::binary, 0.5, 0}}, {}, "box");
    const auto& v = truth.visibility[0].pixels;
    const auto open = static_cast<std::uint64_t>(std::count(v.begin(), v.end(), 1.0f));
    EXPECT_GT(truth.open_pixels, 1000u);
    EXPECT_GT(static_cast<double>(truth.open_pixels), 0.75 * static_cast<double>(open));
}

TEST(OpenSpace, ShadingNormalsAreAlwaysTraced) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(5, 2));
    TruthSettings settings;
    settings.shading_normals = true;
    const CameraFrame frame(testing::looking({1, 5, 1}, {0, 0, 0}), 16, 16);
    EXPECT_EQ(ReferenceScene(scene).trace(frame, {{Falloff::binary, 1, 0}}, settings, "smooth").open_pixels,
              0u);
}

}  // namespace
}  // namespace aoscore
