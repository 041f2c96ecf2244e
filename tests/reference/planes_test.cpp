#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore {
namespace {

/// Traces every ray, since pixels proven open would hide a fault.
TruthSettings every_ray(int samples) {
    TruthSettings settings;
    settings.samples = samples;
    settings.skip_open = false;
    return settings;
}

/// Counts pixels of a lone plane that are not exactly open, over tilts from facing to grazing.
int darkened_pixels(double half_size, int cells, double radius_m, double scale,
                    const glm::dvec3& translation) {
    int darkened = 0;
    for (const double tilt_deg : {0.0, 30.0, 60.0, 85.0, 89.5}) {
        for (const double turn_rad : {0.0, 0.3, 1.1}) {
            Scene scene = testing::empty_scene();
            testing::add(scene, testing::floor_grid(half_size, cells));
            const double elevation = std::numbers::pi / 2 - tilt_deg * std::numbers::pi / 180;
            Camera camera =
                testing::looking(3.0 * glm::dvec3(std::cos(elevation), std::sin(elevation), 0.0), {0, 0, 0});
            const testing::Similarity by{scale, glm::normalize(glm::dvec3(1, 0.4, -0.7)), turn_rad,
                                         translation};
            const ReferenceScene reference(testing::moved(scene, by));
            const CameraFrame frame(testing::moved(camera, by), 40, 30);
            const Truth truth =
                reference.trace(frame, {{Falloff::binary, radius_m * scale, 0}}, every_ray(64), "plane");
            EXPECT_GT(std::count(truth.hits.surface.pixels.begin(), truth.hits.surface.pixels.end(), 1), 100);
            darkened += static_cast<int>(std::count_if(truth.visibility[0].pixels.begin(),
                                                       truth.visibility[0].pixels.end(),
                                                       [](float v) { return v != 1.0f; }));
        }
    }
    return darkened;
}

TEST(Plane, IsExactlyOpenAtEveryTilt) {
    EXPECT_EQ(darkened_pixels(40, 1, 1, 1, glm::dvec3(0)), 0);
    EXPECT_EQ(darkened_pixels(40, 1, INFINITY, 1, glm::dvec3(0)), 0);
}

TEST(Plane, IsExactlyOpenWhenCutIntoManyTriangles) {
    EXPECT_EQ(darkened_pixels(40, 400, INFINITY, 1, glm::dvec3(0)), 0);
}

TEST(Plane, IsExactlyOpenAtEveryScaleAndFarFromTheOrigin) {
    for (const double scale : {1e-3, 1.0, 1e5}) {
        EXPECT_EQ(darkened_pixels(40, 7, INFINITY, scale, glm::dvec3(0)), 0) << scale;
        EXPECT_EQ(darkened_pixels(40, 7, 1, scale, scale * glm::dvec3(1e6, 1e6, -1e6)), 0) << scale;
    }
}

TEST(Plane, ConvexBodyIsOpenOutside) {
    // Every facet's plane has the rest of the sphere behind it, so that no ray may hit at any edge.
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::sphere({0.3, -0.2, 0.1}, 1, 96));
    const ReferenceScene reference(scene);
    const CameraFrame frame(testing::looking({2, 2, 2}, {0, 0, 0}), 96, 96);
    const Truth truth = reference.trace(frame, {{Falloff::binary, INFINITY, 0}}, every_ray(64), "sphere");
    const float least =
        *std::min_element(truth.visibility[0].pixels.begin(), truth.visibility[0].pixels.end());
    EXPECT_EQ(least, 1.0f);
}

TEST(Plane, ClosedBoxLetsNoLightThroughItsEdges) {
    Scene scene = testing::empty_scene();
    testing::add(scene, testing::sphere({10.3, -7.2, 3.1}, 2, 24));
    const ReferenceScene reference(scene);
    const CameraFrame frame(testing::looking({10.3, -7.2, 3.1}, {11.3, -8.9, 3.2}, 2.0), 64, 64);
    const Truth truth = reference.trace(frame, {{Falloff::binary, INFINITY, 0}}, every_ray(256), "inside");
    const float most =
        *std::max_element(truth.visibility[0].pixels.begin(), truth.visibility[0].pixels.end());
    EXPECT_EQ(most, 0.0f);
}

}  // namespace
}  // namespace aoscore
