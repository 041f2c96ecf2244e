#include "jobs/environment_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace aoscore {
namespace {

constexpr int kSize = 48;
constexpr double kPi = std::numbers::pi;

/// A picture whose camera looks down on a floor: the view's z is the world's up.
class LightModes : public ::testing::Test {
  protected:
    LightModes() {
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
        const EnvironmentCones cones(sky);
        const CameraFrame frame(camera_, kSize, kSize);
        const auto mode = std::ranges::find(light_modes(), id, &LightMode::id);
        return double{lit_image(*mode, {cones, frame, normals_}, image_, valid_).at(7, 9).y};
    }

    Camera camera_;
    MethodOutput image_;
    Image<glm::vec3> normals_{kSize, kSize, glm::vec3(0, 0, 1)};
    Mask valid_{kSize, kSize, 1};
};

TEST_F(LightModes, UnderAnEvenSkyAllThatUseVisibilityAreVisibility) {
    for (const LightMode& mode : light_modes()) {
        const double expected = mode.alone ? std::pow(std::sin(kPi / 4), 2) : 0.6;
        EXPECT_NEAR(lit(std::string(mode.id).c_str(), {.even = 1}), expected, 1e-6) << mode.id;
    }
}

// The mean of cos² over cones, as tests/core/sky_test.cpp has it; the bent normal's height is .8.
TEST_F(LightModes, SeekAGradientAlongTheirAxisInTheirCone) {
    const Sky slope{.slope = 1};
    const double cone = 2.0 / 3 * (1 - std::pow(std::cos(kPi / 4), 3)) / 0.5;
    EXPECT_NEAR(lit("normal", slope), 0.6 * 2 / 3, 2e-3);
    EXPECT_NEAR(lit("bent_normal", slope), 0.6 * 0.8 * 2 / 3, 2e-3);
    EXPECT_NEAR(lit("cone", slope), 0.6 * 0.8 * cone, 2e-3);
    EXPECT_NEAR(lit("cone_alone", slope), 0.5 * 0.8 * cone, 2e-3);
}

TEST_F(LightModes, WithoutABentNormalAreLitAlongTheNormal) {
    bend({0, 0, 0});
    EXPECT_NEAR(lit("bent_normal", {.slope = 1}), 0.6 * 2 / 3, 2e-3);
}

// Noise of the truth that its halves do not share leaves the error alone.
TEST_F(LightModes, ErrWithoutTheNoiseOfTheRays) {
    const EnvironmentCones cones(Sky{.even = 1});
    const CameraFrame frame(camera_, kSize, kSize);
    Irradiance truth;
    truth.halves.fill(Image<glm::vec3>(kSize, kSize, glm::vec3(0.5F)));
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            truth.halves[0].at(x, y) += x % 2 == 0 ? 0.2F : -0.2F;
            truth.halves[1].at(x, y) += y % 2 == 0 ? 0.2F : -0.2F;
        }
    }
    const auto errors = light_errors({cones, frame, normals_}, image_, truth, valid_, 1);
    EXPECT_NEAR(errors.at("rmse.normal").value, 0.1, 1e-6);
    EXPECT_NEAR(errors.at("gain.cone").value, 0, 1e-6);
    EXPECT_FALSE(errors.at("rmse.cone").interval) << "no resampled picture changes it";
    for (int y = 0; y < kSize; ++y) truth.halves[0].at(0, y) += static_cast<float>(y) / kSize;
    const auto uneven = light_errors({cones, frame, normals_}, image_, truth, valid_, 1).at("rmse.cone");
    ASSERT_TRUE(uneven.interval);
    EXPECT_LE(uneven.interval->low, uneven.value);
    EXPECT_GE(uneven.interval->high, uneven.value);
    EXPECT_NEAR(errors.at("relative_rmse.normal").value, 0.2, 1e-6);
    EXPECT_NEAR(errors.at("bias.normal").value, 0.2, 1e-6) << ".6 where .5 is right";
}

TEST_F(LightModes, ApplyToWhatHasTheirSignals) {
    const auto applying = [&] {
        std::vector<std::string> ids;
        for (const LightMode& mode : light_modes()) {
            if (applies(mode, image_)) ids.emplace_back(mode.id);
        }
        return ids;
    };
    EXPECT_EQ(applying().size(), light_modes().size());
    image_.signals.erase("cone_angle");
    EXPECT_EQ(applying(), (std::vector<std::string>{"normal", "bent_normal"}));
    image_.signals.clear();
    EXPECT_EQ(applying(), (std::vector<std::string>{"normal"}));
}

TEST_F(LightModes, GiveNoErrorsWithoutAPixel) {
    const EnvironmentCones cones(Sky{.even = 1});
    Irradiance truth;
    truth.halves.fill(Image<glm::vec3>(kSize, kSize, glm::vec3(0.5F)));
    const CameraFrame frame(camera_, kSize, kSize);
    EXPECT_TRUE(light_errors({cones, frame, normals_}, image_, truth, Mask(kSize, kSize, 0), 1).empty());
}

// Red from the left, green from the right: the axis decides the colour.
TEST_F(LightModes, KeepColours) {
    EnvironmentMap map{Image<glm::vec3>(64, 32, glm::vec3(0, 1, 0)), 0};
    for (int y = 0; y < 32; ++y) {
        for (int x = 16; x < 48; ++x) map.radiance.at(x, y) = glm::vec3(1, 0, 0);  // towards +x
    }
    const EnvironmentCones cones(Environment(map, "two colours"));
    const CameraFrame frame(camera_, kSize, kSize);
    const auto mode = std::ranges::find(light_modes(), "bent_normal", &LightMode::id);
    for (const float side : {-1.0F, 1.0F}) {
        bend({side, 0, 0});  // the view's x is the world's
        const glm::vec3 lit = lit_image(*mode, {cones, frame, normals_}, image_, valid_).at(3, 4);
        EXPECT_NEAR(side > 0 ? lit.x : lit.y, 0.6F, 0.01F);
        EXPECT_NEAR(side > 0 ? lit.y : lit.x, 0, 0.01F);
    }
}

}  // namespace
}  // namespace aoscore
