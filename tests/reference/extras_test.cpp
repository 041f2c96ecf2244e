#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

TruthSettings with_extras(int samples) {
    TruthSettings settings;
    settings.samples = samples;
    settings.extras = {true, true, true};
    return settings;
}

/// Occlusion of one pixel by cause, and the one-layer bound.
struct Split {
    std::array<double, kCauses> by_cause{};
    double bound = 0, occlusion = 0;
};

/// The split of the middle pixel.
Split split(const Scene& scene, const Camera& camera, double radius_m, int width = 65, int height = 49) {
    const CameraFrame frame(camera, width, height);
    const Truth truth =
        ReferenceScene(scene).trace(frame, {{Falloff::binary, radius_m, 0}}, with_extras(1024), "causes");
    Split s;
    const std::size_t middle = truth.hits.depth.index(width / 2, height / 2);
    for (std::size_t c = 0; c < kCauses; ++c) s.by_cause[c] = truth.occlusion_by_cause[c].pixels[middle];
    s.bound = truth.one_layer_bound.pixels[middle];
    s.occlusion = 1.0 - truth.visibility[0].pixels[middle];
    return s;
}

Scene floor_only() {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::floor_grid(50, 1));
    return scene;
}

double part(const Split& s, Cause cause) {
    return s.by_cause[static_cast<std::size_t>(cause)];
}

TEST(Causes, AddUpToTheOcclusion) {
    for (const Falloff falloff : {Falloff::binary, Falloff::quadratic, Falloff::xegtao}) {
        const CameraFrame frame(testing::looking({2, 2, 3}, {0, 0.6, 0}), 64, 48);
        const Truth truth =
            ReferenceScene(testing::thicket())
                .trace(frame, {{falloff, 1, 0}, {Falloff::binary, 2, 0}}, with_extras(64), "sum");
        double most = 0, bound_excess = 0;
        for (std::size_t i = 0; i < truth.visibility[0].size(); ++i) {
            double sum = 0;
            for (const ImageF& image : truth.occlusion_by_cause) sum += image.pixels[i];
            most = std::max(most, std::abs(sum - (1.0 - truth.visibility[0].pixels[i])));
            bound_excess = std::max<double>(
                bound_excess, truth.one_layer_bound.pixels[i] - (1.0 - truth.visibility[0].pixels[i]));
        }
        EXPECT_LT(most, 1e-6);
        EXPECT_LT(bound_excess, 1e-6) << "the bound cannot exceed the occlusion";
    }
}

TEST(Causes, ARoofAboveThePictureIsOutside) {
    Scene scene = floor_only();
    testing::add(scene, testing::quad({-9, 3, -9}, {9, 3, -9}, {9, 3, 9}, {-9, 3, 9}));
    const Split s = split(scene, testing::looking({0, 1, 4}, {0, 0, 0}, 0.3), 5);
    EXPECT_GT(s.occlusion, 0.5);
    EXPECT_NEAR(part(s, Cause::outside), s.occlusion, 1e-6);
    EXPECT_EQ(s.bound, 0);
}

TEST(Causes, TheUndersideOfATableSeenFromAboveIsHidden) {
    Scene scene = floor_only();
    testing::add(scene, testing::quad({-2, 0.5, -2}, {0, 0.5, -2}, {0, 0.5, 2}, {-2, 0.5, 2}));  // underside
    testing::add(scene, testing::quad({-2, 0.8, -2}, {0, 0.8, -2}, {0, 0.8, 2}, {-2, 0.8, 2}));  // top
    testing::add(scene, testing::quad({0, 0.5, -2}, {0, 0.8, -2}, {0, 0.8, 2}, {0, 0.5, 2}));    // edge
    const Split s = split(scene, testing::looking({3, 3, 0}, {0.3, 0, 0}, 1.2), 1.5);
    EXPECT_GT(part(s, Cause::hidden), 0.1);
    EXPECT_GT(part(s, Cause::visible), 0.005);
    EXPECT_NEAR(part(s, Cause::hidden) + part(s, Cause::visible), s.occlusion, 1e-6);
}

TEST(Causes, AWallSeenFaceOnIsVisibleAndEdgeOnGrazing) {
    Scene scene = floor_only();
    testing::add(scene, testing::quad({-3, 0, -0.5}, {3, 0, -0.5}, {3, 1, -0.5}, {-3, 1, -0.5}));
    const Split face = split(scene, testing::looking({0, 2, 4}, {0, 0, 0}, 1.2), 1);
    EXPECT_GT(face.occlusion, 0.15);
    EXPECT_GT(part(face, Cause::visible), 0.98 * face.occlusion);
    EXPECT_NEAR(face.bound, part(face, Cause::visible), 1e-6);

    Camera along = testing::looking({3, 0.3, -0.48}, {0, 0, 0}, 1.2);
    const Split edge = split(scene, along, 1);
    EXPECT_GT(part(edge, Cause::grazing), 0.5 * edge.occlusion);
    EXPECT_LT(part(edge, Cause::visible), 0.02 * edge.occlusion);
}

TEST(Causes, ABoundLooksBehindWhatIsHidden) {
    // A low box hides its back wall from the camera; a tall wall behind it shows above: rays that meet the
    // hidden back first reach the visible wall after.
    Scene scene = floor_only();
    testing::add(scene, testing::quad({-4, 0, -0.4}, {4, 0, -0.4}, {4, 0.3, -0.42}, {-4, 0.3, -0.42}));
    testing::add(scene, testing::quad({-4, 0, -0.6}, {4, 0, -0.6}, {4, 3, -0.6}, {-4, 3, -0.6}));
    const Split s = split(scene, testing::looking({0, 3, 3}, {0, 0, 0}, 1.4), 2);
    EXPECT_GE(s.bound, part(s, Cause::visible) - 1e-6);
    EXPECT_LE(s.bound, s.occlusion + 1e-6);
}

}  // namespace
}  // namespace aoscore
