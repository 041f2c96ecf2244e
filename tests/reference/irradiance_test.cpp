#include "reference/irradiance.h"

#include "core/threads.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSize = 8, kSamples = 1024;

/// The mean over a narrow view in which all pixels see the same.
double mean_irradiance(const Scene& scene, const Camera& camera, const Sky& sky, double radius_m = INFINITY) {
    const CameraFrame frame(camera, kSize, kSize);
    const Irradiance light = trace_irradiance(scene, frame, sky, radius_m, kSamples, 1);
    double sum = 0;
    for (const ImageF& half : light.halves) {
        for (const float value : half.pixels) sum += double{value};
    }
    return sum / (2 * kSize * kSize);
}

Camera downward() {
    return looking({0.3, 2, 0.2}, {0, 0, 0}, 0.001);
}

Scene floor_alone() {
    Scene scene = empty_scene();
    add(scene, floor_grid(100, 1));
    return scene;
}

/// A wall of 200 m before the point that the camera sees, a centimetre from it: half of the sky is hidden.
Scene floor_before_a_wall() {
    Scene scene = floor_alone();
    add(scene, quad({-0.01, 0, -200}, {-0.01, 200, -200}, {-0.01, 200, 200}, {-0.01, 0, 200}));
    return scene;
}

TEST(TracedIrradiance, UnderAnEvenSkyIsVisibility) {
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), {.even = 1}), 1, 1e-6);
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {.even = 1}), 0.5, 0.002);
}

TEST(TracedIrradiance, OfATiltedPlaneUnderAHalfWhiteSkyIsItsClosedForm) {
    const double tilt = kPi / 3;
    const Similarity turned{.axis = {0, 0, 1}, .angle_rad = tilt};
    EXPECT_NEAR(mean_irradiance(moved(floor_alone(), turned), moved(downward(), turned), {.upper = 1}),
                (1 + std::cos(tilt)) / 2, 0.002);
}

// The integral of cos² over the hemisphere is 2/3 pi, and over the quarter that a wall leaves half of it.
TEST(TracedIrradiance, UnderALinearGradientIsItsClosedForm) {
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), {.slope = 1}), 2.0 / 3, 0.001);
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {.slope = 1}), 1.0 / 3, 0.002);
}

TEST(TracedIrradiance, IsHiddenWithinTheRadiusAlone) {
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {.even = 1}, 0.005), 1, 1e-6);
}

TEST(TracedIrradiance, AgreesWithMapsOfTheSkyAndDoesNotDependOnThreads) {
    const SkyCones cones(generated_sky());
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), generated_sky()),
                cones.mean_radiance({0, 1, 0}, kPi / 2), 0.003);
    const CameraFrame frame(looking({0, 2, 5}, {0, 0.5, 0}), 32, 24);
    const auto traced = [&] { return trace_irradiance(still_life(), frame, generated_sky(), 1, 16, 3); };
    const Irradiance all = traced();
    set_thread_count(1);
    const Irradiance one = traced();
    set_thread_count(0);
    EXPECT_EQ(all.halves[0].pixels, one.halves[0].pixels);
    EXPECT_NE(all.halves[0].pixels, all.halves[1].pixels) << "their rays are not the same";
}

}  // namespace
}  // namespace aoscore::testing
