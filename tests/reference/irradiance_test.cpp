#include "reference/irradiance.h"

#include "core/environment_cones.h"
#include "core/threads.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSize = 8, kSamples = 1024;

/// The mean over a narrow view in which all pixels see the same.
double mean_irradiance(const Scene& scene, const Camera& camera, const Environment& light,
                       double radius_m = INFINITY) {
    const CameraFrame frame(camera, kSize, kSize);
    const Irradiance traced = trace_irradiance(scene, frame, light, radius_m, kSamples, 1);
    double sum = 0;
    for (const Image<glm::vec3>& half : traced.halves) {
        for (const glm::vec3& value : half.pixels) sum += luminance(glm::dvec3(value));
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
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), Sky{.even = 1}), 1, 1e-6);
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), Sky{.even = 1}), 0.5, 0.002);
}

TEST(TracedIrradiance, OfATiltedPlaneUnderAHalfWhiteSkyIsItsClosedForm) {
    const double tilt = kPi / 3;
    const Similarity turned{.axis = {0, 0, 1}, .angle_rad = tilt};
    EXPECT_NEAR(mean_irradiance(moved(floor_alone(), turned), moved(downward(), turned), Sky{.upper = 1}),
                (1 + std::cos(tilt)) / 2, 0.002);
}

// The integral of cos² over the hemisphere is 2/3 pi, and over the quarter that a wall leaves half of it.
TEST(TracedIrradiance, UnderALinearGradientIsItsClosedForm) {
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), Sky{.slope = 1}), 2.0 / 3, 0.001);
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), Sky{.slope = 1}), 1.0 / 3, 0.002);
}

TEST(TracedIrradiance, IsHiddenWithinTheRadiusAlone) {
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), Sky{.even = 1}, 0.005), 1, 1e-6);
}

TEST(TracedIrradiance, AgreesWithMapsOfTheSkyAndDoesNotDependOnThreads) {
    const EnvironmentCones cones(generated_sky());
    EXPECT_NEAR(mean_irradiance(floor_alone(), downward(), generated_sky()),
                cones.mean_radiance({0, 1, 0}, kPi / 2).y, 0.003);
    const CameraFrame frame(looking({0, 2, 5}, {0, 0.5, 0}), 32, 24);
    const auto traced = [&] { return trace_irradiance(still_life(), frame, generated_sky(), 1, 16, 3); };
    const Irradiance all = traced();
    set_thread_count(1);
    const Irradiance one = traced();
    set_thread_count(0);
    EXPECT_EQ(all.halves[0].pixels, one.halves[0].pixels);
    EXPECT_NE(all.halves[0].pixels, all.halves[1].pixels) << "their rays are not the same";
}

/// A picture of one bright texel on black, whose middle is `down` of the way from zenith to nadir.
Environment one_texel(int x, int y) {
    EnvironmentMap map{Image<glm::vec3>(128, 64, glm::vec3(0)), 0};
    map.radiance.at(x, y) = glm::vec3(2e4F, 1e4F, 5e3F);
    return {map, "one texel"};
}

// The integral of cos over a texel, over pi: its mean height times its solid angle.
TEST(TracedIrradiance, OfASmallSunIsItsClosedFormAtThreeScales) {
    const Environment sun = one_texel(70, 20);
    const double top = kPi * 20 / 64, bottom = kPi * 21 / 64;
    const double cosines = (std::pow(std::sin(bottom), 2) - std::pow(std::sin(top), 2)) / 2 * (2 * kPi / 128);
    const double expected = cosines / kPi * luminance({2e4, 1e4, 5e3});
    for (const double scale : {0.01, 1.0, 100.0}) {
        const Similarity scaled{.scale = scale};
        const Scene scene = moved(floor_alone(), scaled);
        EXPECT_NEAR(mean_irradiance(scene, moved(downward(), scaled), sun) / expected, 1, 2e-3) << scale;
        const Scene walled = moved(floor_before_a_wall(), scaled);  // the texel lies towards +x, past no wall
        EXPECT_NEAR(mean_irradiance(walled, moved(downward(), scaled), sun) / expected, 1, 2e-3) << scale;
        const Environment behind = one_texel(6, 20);  // towards -x
        EXPECT_NEAR(mean_irradiance(walled, moved(downward(), scaled), behind) / expected, 0, 1e-9) << scale;
    }
}

TEST(TracedIrradiance, UnderAnEvenPictureIsVisibilityAtThreeScales) {
    const Environment even(EnvironmentMap{Image<glm::vec3>(8, 4, glm::vec3(3)), 0}, "even");
    for (const double scale : {0.01, 1.0, 100.0}) {
        const Similarity scaled{.scale = scale};
        EXPECT_NEAR(
            mean_irradiance(moved(floor_before_a_wall(), scaled), moved(downward(), scaled), even) / 3, 0.5,
            0.002)
            << scale;
    }
}

// A picture of the right half of the sky: the wall hides the other one.
TEST(TracedIrradiance, IsThatOfThePicturesRightSide) {
    EnvironmentMap half{Image<glm::vec3>(64, 32, glm::vec3(0)), 0};
    for (int y = 0; y < 32; ++y) {
        for (int x = 16; x < 48; ++x) half.radiance.at(x, y) = glm::vec3(1);  // towards +x
    }
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {half, "+x"}), 0.5, 0.002);
    half.turn_rad = kPi;
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {half, "-x"}), 0, 0.002);
    half.turn_rad = kPi / 2;  // towards -z
    EXPECT_NEAR(mean_irradiance(floor_before_a_wall(), downward(), {half, "-z"}), 0.25, 0.002);
}

// Over many seeds the mean square of the true error is the square of the stated one.
TEST(TracedIrradiance, HasTheErrorThatItStates) {
    const CameraFrame frame(looking({0, 2, 5}, {0, 0.5, 0}), 32, 24);
    const Mask all(32, 24, 1);
    const Environment sun = one_texel(70, 12);
    for (const Environment& light : {Environment(generated_sky()), sun}) {
        const Irradiance best = trace_irradiance(still_life(), frame, light, 1, 4096, 1);
        double squares = 0, stated = 0;
        for (std::uint64_t seed = 2; seed < 22; ++seed) {
            const Irradiance few = trace_irradiance(still_life(), frame, light, 1, 16, seed);
            stated += std::pow(standard_error(few, all), 2);
            for (std::size_t i = 0; i < all.size(); ++i)
                squares +=
                    std::pow(luminance(few.mean(i) - best.mean(i)), 2) / static_cast<double>(all.size());
        }
        EXPECT_NEAR(squares / stated, 1, 0.15) << light.id();
    }
}

TEST(TracedIrradiance, IsTracedToItsGoalOrToTheMostRays) {
    const CameraFrame frame(looking({0, 2, 5}, {0, 0.5, 0}), 32, 24);
    const auto traced = [&](const IrradianceGoal& goal) {
        return trace_irradiance(still_life(), frame, generated_sky(), 1, goal, 1);
    };
    const Irradiance sure = traced({.relative_error = 0.005, .first = 16, .most = 4096});
    Mask lit(32, 24, 0);
    for (std::size_t i = 0; i < lit.size(); ++i) lit.pixels[i] = luminance(sure.mean(i)) > 0 ? 1 : 0;
    EXPECT_LE(standard_error(sure, lit), 0.005 * mean_luminance(sure, lit));
    EXPECT_GT(sure.samples, 16);
    EXPECT_EQ(traced({.relative_error = 1e-9, .first = 16, .most = 64}).samples, 64);
}

}  // namespace
}  // namespace aoscore::testing
