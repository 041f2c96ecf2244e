#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore::testing {
namespace {

// Tests methods on a plane, which is open everywhere: V = 1, or the value of a method's own formula there.
class Plane : public ::testing::Test {
  protected:
    double mean(const std::string& method, const std::string& preset, const ParameterValues& overrides,
                const glm::dvec3& normal, std::uint64_t seed = 1) {
        renderer_.set_scene(plane_scene({0, 0, -4}, glm::normalize(normal), 30));
        renderer_.draw_gbuffer(CameraFrame(front_camera(), 96, 54), gbuffer_inputs());
        MethodRequest request = request_for(find_method(methods_, method), filters_, preset, overrides);
        request.seed = seed;
        return mean_over(renderer_.run(request).raw, renderer_.read_gbuffer().surface);
    }
    // The mean over kernels, of which a seed has only one.
    double mean_over_seeds(const std::string& method, const std::string& preset,
                           const ParameterValues& overrides) {
        constexpr int kSeeds = 300;
        renderer_.set_scene(plane_scene({0, 0, -4}, {0, 0, 1}, 30));
        renderer_.draw_gbuffer(CameraFrame(front_camera(), 24, 16), gbuffer_inputs());
        const Mask surface = renderer_.read_gbuffer().surface;
        MethodRequest request = request_for(find_method(methods_, method), filters_, preset, overrides);
        request.filter = nullptr;
        request.uniform_form = true;  // one shader for all seeds
        double sum = 0;
        for (request.seed = 1; request.seed <= kSeeds; ++request.seed)
            sum += mean_over(renderer_.run(request).raw, surface);
        return sum / kSeeds;
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    std::vector<MethodDescriptor> filters_ = load_filters();
    ScreenRenderer renderer_;
};

// Half of the sphere lies behind a facing plane; the bias opens the points within it. The expected values
// follow from the distribution of the kernel's points: a uniform radius times lerp(0.1, 1, (i/N)^2), in
// directions of a cube.
TEST_F(Plane, FacingIsHalfOpenToCrytekWithoutBias) {
    EXPECT_NEAR(mean_over_seeds("crytek-ssao", "quality", {{"bias", 0.0}}), 0.5, 0.01);
}
TEST_F(Plane, FacingReadsWhatTheBiasOpensToCrytek) {
    EXPECT_NEAR(mean_over_seeds("crytek-ssao", "performance-wide", {}), 0.82, 0.015);
    EXPECT_NEAR(mean_over_seeds("crytek-ssao", "quality", {}), 0.77, 0.015);
}
TEST_F(Plane, FacingIsNearlyOpenToTheInnermostSixteenOfSixtyFour) {
    EXPECT_NEAR(mean_over_seeds("crytek-ssao", "performance-wide", {{"kernel_scale", "squared_of_64"}}), 0.98,
                0.01);
}

// The horizon of a plane is its tangent, in every direction, in perspective, without any bias.
TEST_F(Plane, TiltedIsOpenToHbaoWithoutBias) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        const double angle = degrees * M_PI / 180;
        const glm::dvec3 normal(std::sin(angle) * 0.8, std::sin(angle) * 0.6, std::cos(angle));
        EXPECT_NEAR(mean("hbao", "quality", {{"bias", 0.0}}, normal), 1, 2e-4) << degrees;
        EXPECT_EQ(mean("hbao", "default", {}, normal), 1) << degrees;
        EXPECT_NEAR(mean("hbao-hussain", "quality", {{"bias", 0.0}, {"tangent", "plane"}}, normal), 1, 2e-4)
            << degrees;
    }
}

// Its printed tangent angle is right where the direction runs up the slope and too low elsewhere: the bias
// hides that up to a certain tilt.
TEST_F(Plane, TiltedIsOpenToHussainsHbaoWhileTheBiasHidesItsTangent) {
    EXPECT_EQ(mean("hbao-hussain", "quality", {}, {0, 0, 1}), 1);
    EXPECT_NEAR(mean("hbao-hussain", "quality", {}, {0.5, 0, 1}), 1, 1e-3);
    EXPECT_LT(mean("hbao-hussain", "quality", {}, {4, 0, 1}), 0.99);
}

TEST_F(Plane, TiltedIsOpenToAlchemy) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        const double angle = degrees * M_PI / 180;
        const glm::dvec3 normal(std::sin(angle) * 0.8, std::sin(angle) * 0.6, std::cos(angle));
        EXPECT_NEAR(mean("alchemy", "quality", {}, normal), 1, 1e-6) << degrees;
        EXPECT_NEAR(mean("alchemy", "quality", {{"beta", 0.0}}, normal), 1, 2e-3) << degrees;
    }
}

}  // namespace
}  // namespace aoscore::testing
