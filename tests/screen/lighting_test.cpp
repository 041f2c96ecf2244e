// Tests the lighting pass: ambient light times visibility, Lambert times each light, and its highlight.
#include "hand_made.h"
#include "screen/method/request_digest.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

class Lighting : public ::testing::Test {
  protected:
    static constexpr int kWidth = 96, kHeight = 54;

    MethodRequest request(const ParameterValues& overrides) const {
        MethodRequest request = request_for(find_method(methods_, "alchemy"), filters_, "default");
        request.lighting = &lighting_;
        request.lighting_parameters = lighting_.values("default", overrides);
        return request;
    }
    MethodOutput draw(const Scene& scene, const Camera& camera, const ParameterValues& overrides) {
        renderer_.set_scene(scene);
        const MethodRequest wanted = request(overrides);
        renderer_.draw_gbuffer(CameraFrame(camera, kWidth, kHeight), needed_gbuffer_inputs(wanted));
        return renderer_.run(wanted);
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    std::vector<MethodDescriptor> filters_ = load_filters();
    MethodDescriptor lighting_ = load_lighting();
    ScreenRenderer renderer_;
};

// The hue of a light, in double: red, yellow, green, cyan, blue, magenta around the circle.
glm::dvec3 hue(double turn) {
    const auto channel = [&](double shift) {
        const double t = turn + shift;
        return std::clamp(std::abs((t - std::floor(t)) * 6 - 3) - 1, 0.0, 1.0);
    };
    return {channel(0), channel(2.0 / 3), channel(1.0 / 3)};
}

// Phong's model of a point on a plane that a camera at the origin sees.
glm::dvec3 lit_by_hand(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& albedo,
                       double visibility) {
    glm::dvec3 sum = 0.75 * visibility * albedo;
    for (int i = 0; i < 4; ++i) {
        const double turn = (i + 0.5) / 4, angle = 2 * std::numbers::pi * turn;
        const glm::dvec3 light(2 * std::cos(angle), 2 * std::sin(angle), -4);
        const glm::dvec3 to_light = glm::normalize(light - position);
        const double distance = glm::distance(light, position), lambert = glm::dot(normal, to_light);
        if (lambert <= 0) continue;
        const glm::dvec3 mirrored = 2 * lambert * normal - to_light;
        const double highlight =
            0.2 * std::pow(std::max(0.0, glm::dot(mirrored, -glm::normalize(position))), 32);
        const glm::dvec3 colour = 0.5 * (0.5 + 0.5 * hue(turn));
        sum += colour * (albedo * lambert + highlight) / (1 + std::pow(distance / 5, 2));
    }
    return sum;
}

TEST_F(Lighting, OfATiltedPlaneIsPhongsModel) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.2, 1)), albedo(0.8, 0.5, 0.25);
    Scene scene = plane_scene({0, 0, -6}, normal, 60);
    scene.materials[0].base_color = glm::vec4(glm::vec3(albedo), 1.0F);
    const CameraFrame frame(front_camera(), kWidth, kHeight);
    const MethodOutput output = draw(scene, front_camera(), {});
    const GBufferImages images = renderer_.read_gbuffer();
    for (const glm::ivec2 pixel :
         {glm::ivec2(48, 27), glm::ivec2(5, 5), glm::ivec2(90, 10), glm::ivec2(20, 50)}) {
        const glm::dvec3 position = frame.view_position(
            pixel.x + 0.5, pixel.y + 0.5, static_cast<double>(images.linear_depth().at(pixel.x, pixel.y)));
        const auto visibility = static_cast<double>(output.visibility.at(pixel.x, pixel.y));
        const glm::dvec3 expected = lit_by_hand(position, normal, albedo, visibility);
        const glm::dvec3 got(output.lit.at(pixel.x, pixel.y));
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(got[channel], expected[channel], 2e-5) << pixel.x << ", " << pixel.y;
    }
}

TEST_F(Lighting, WithoutLightsIsAmbientTimesVisibilityAfterItsFilter) {
    const MethodOutput output = draw(corner_scene(), corner_camera(), {{"intensity", 0}});
    const Mask surface = renderer_.read_gbuffer().surface;
    bool occluded = false, background = false;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const float expected = surface.pixels[i] != 0 ? 0.75F * output.visibility.pixels[i] : 0.0F;
        EXPECT_NEAR(output.lit.pixels[i].x, expected, 1e-6) << i;
        occluded |= output.visibility.pixels[i] < 0.8F;
        background |= surface.pixels[i] == 0;
    }
    EXPECT_TRUE(occluded && background) << "the scene has both";
}

// Row 0 is at the top, and light from the right falls on surfaces that face right.
TEST_F(Lighting, IsNeitherMirroredNorUpsideDown) {
    const MethodOutput output = draw(plane_scene({0, 0, -6}, {0, 0, 1}, 60), front_camera(),
                                     {{"lights", 4}, {"saturation", 1}, {"ring", 3}, {"ahead", 5}});
    // At an eighth of a turn, at the upper right, the hue is between yellow and red, and so on
    // counter-clockwise.
    const auto near_light = [&](int i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / 4;
        const glm::dvec3 image = CameraFrame(front_camera(), kWidth, kHeight)
                                     .project({3 * std::cos(angle), 3 * std::sin(angle), -6});
        return output.lit.at(static_cast<int>(image.x), static_cast<int>(image.y));
    };
    EXPECT_GT(near_light(0).x, near_light(0).z) << "above on the right: red and yellow, no blue";
    EXPECT_GT(near_light(2).z, near_light(2).x) << "below on the left: blue, no red";
}

TEST_F(Lighting, IsDrawnOnlyWhereItIsAskedFor) {
    MethodRequest plain = request({});
    plain.lighting = nullptr;
    EXPECT_FALSE(needed_gbuffer_inputs(plain).contains("albedo"));
    EXPECT_TRUE(needed_gbuffer_inputs(request({})).contains("albedo"));
    renderer_.set_scene(corner_scene());
    renderer_.draw_gbuffer(CameraFrame(corner_camera(), kWidth, kHeight), needed_gbuffer_inputs(plain));
    EXPECT_TRUE(renderer_.run(plain).lit.empty());
    EXPECT_FALSE(renderer_.time(plain).lighting);
}

TEST_F(Lighting, IsPartOfWhatDecidesARequest) {
    MethodRequest plain = request({});
    plain.lighting = nullptr;
    EXPECT_NE(request_digest(plain, false), request_digest(request({}), false));
    EXPECT_NE(request_digest(request({{"ambient", 0.5}}), false), request_digest(request({}), false));
}

TEST_F(Lighting, OfAWholeFrameIsThatOfItsPasses) {
    const MethodOutput once = draw(corner_scene(), corner_camera(), {});
    const std::string before = renderer_.gbuffer_digest();
    using Waits = ScreenRenderer::Waits;
    for (const Waits waits : {Waits::after_every_pass, Waits::at_the_end})
        EXPECT_GT(renderer_.time_frame(request({}), waits).processor_ms, 0);
    EXPECT_EQ(renderer_.gbuffer_digest(), before) << "drawn again as it was";
    EXPECT_EQ(renderer_.run(request({})).lit.pixels, once.lit.pixels);
}

TEST_F(Lighting, OfTheAtriumCanBeLookedAt) {
    const Scene scene = load_scene("atrium");
    constexpr int kScale = 6;
    renderer_.set_scene(scene);
    const MethodRequest wanted = request({});
    renderer_.draw_gbuffer(CameraFrame(find_view(scene, "wide").camera, kScale * kWidth, kScale * kHeight),
                           needed_gbuffer_inputs(wanted));
    const Image<glm::vec3> lit = renderer_.run(wanted).lit;
    write_png((output_dir() / "lit.png").string(), lit);
    double mean = 0;
    for (const glm::vec3& pixel : lit.pixels)
        mean += static_cast<double>(pixel.y / static_cast<float>(lit.size()));
    EXPECT_GT(mean, 0.05);
    EXPECT_LT(mean, 0.95);
}

}  // namespace
}  // namespace aoscore::testing
