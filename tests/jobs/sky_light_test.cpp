#include "jobs/sky_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace aoscore {
namespace {

constexpr int kSize = 48;
constexpr double kPi = std::numbers::pi;

/// A picture whose camera looks down on a floor: the view's z is the world's up.
class SkyLightModes : public ::testing::Test {
  protected:
    SkyLightModes() {
        camera_.position = {0, 5, 0};
        camera_.target = {0, 0, 0};
        camera_.up = {0, 0, -1};
        image_.visibility = ImageF(kSize, kSize, 0.6F);
        image_.signals["bent_normal"] = SignalImage(3, ImageF(kSize, kSize, 0));
        image_.signals["cone_angle"] = SignalImage(1, ImageF(kSize, kSize, static_cast<float>(kPi / 4)));
        bend({0.6F, 0, 0.8F});
    }

    /// In view space.
    void bend(const glm::vec3& normal) {
        for (int axis = 0; axis < 3; ++axis) {
            ImageF& plane = image_.signals["bent_normal"][static_cast<std::size_t>(axis)];
            std::fill(plane.pixels.begin(), plane.pixels.end(), normal[axis]);
        }
    }

    double lit(const char* id, const Sky& sky) const {
        const SkyCones cones(sky);
        const CameraFrame frame(camera_, kSize, kSize);
        const auto mode = std::ranges::find(light_modes(), id, &LightMode::id);
        return double{lit_image(*mode, {cones, frame, normals_}, image_, valid_).at(7, 9)};
    }

    Camera camera_;
    MethodOutput image_;
    Image<glm::vec3> normals_{kSize, kSize, glm::vec3(0, 0, 1)};
    Mask valid_{kSize, kSize, 1};
};

TEST_F(SkyLightModes, UnderAnEvenSkyAllThatUseVisibilityAreVisibility) {
    for (const LightMode& mode : light_modes()) {
        const double expected = mode.alone ? std::pow(std::sin(kPi / 4), 2) : 0.6;
        EXPECT_NEAR(lit(std::string(mode.id).c_str(), {.even = 1}), expected, 1e-6) << mode.id;
    }
}

// The mean of cos² over cones, as tests/core/sky_test.cpp has it; the bent normal's height is .8.
TEST_F(SkyLightModes, SeekAGradientAlongTheirAxisInTheirCone) {
    const Sky slope{.slope = 1};
    const double cone = 2.0 / 3 * (1 - std::pow(std::cos(kPi / 4), 3)) / 0.5;
    EXPECT_NEAR(lit("normal", slope), 0.6 * 2 / 3, 2e-3);
    EXPECT_NEAR(lit("bent_normal", slope), 0.6 * 0.8 * 2 / 3, 2e-3);
    EXPECT_NEAR(lit("cone", slope), 0.6 * 0.8 * cone, 2e-3);
    EXPECT_NEAR(lit("cone_alone", slope), 0.5 * 0.8 * cone, 2e-3);
}

TEST_F(SkyLightModes, WithoutABentNormalAreLitAlongTheNormal) {
    bend({0, 0, 0});
    EXPECT_NEAR(lit("bent_normal", {.slope = 1}), 0.6 * 2 / 3, 2e-3);
}

// Noise of the truth that its halves do not share leaves the error alone.
TEST_F(SkyLightModes, ErrWithoutTheNoiseOfTheRays) {
    const SkyCones cones({.even = 1});
    const CameraFrame frame(camera_, kSize, kSize);
    Irradiance truth;
    truth.halves.fill(ImageF(kSize, kSize, 0.5F));
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            truth.halves[0].at(x, y) += x % 2 == 0 ? 0.2F : -0.2F;
            truth.halves[1].at(x, y) += y % 2 == 0 ? 0.2F : -0.2F;
        }
    }
    const auto errors = light_errors({cones, frame, normals_}, image_, truth, valid_, 1);
    EXPECT_NEAR(errors.at("rmse.normal").value, 0.1, 1e-6);
    EXPECT_NEAR(errors.at("gain.cone").value, 0, 1e-6);
    ASSERT_TRUE(errors.at("rmse.cone").interval);
    EXPECT_LE(errors.at("rmse.cone").interval->low, errors.at("rmse.cone").value);
}

}  // namespace
}  // namespace aoscore
