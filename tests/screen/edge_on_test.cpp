// Tests ray marching on a floor that is seen almost edge-on, in double precision: a picture of few texels
// must give the result of one many times as fine. A surface far behind a point must not hide it because its
// texel is tall.
#include "hand_made.h"
#include "oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace aoscore::testing {
namespace {

constexpr int kSize = 160;  ///< side of the shader's picture
constexpr int kFiner = 8;   ///< the formula's picture is so many times as wide and high
constexpr double kRadius = 0.5;
constexpr int kSteps = 48;

struct Picture {
    CameraFrame frame;
    GBufferImages images;
};

// Tilts the camera to `tilt_deg` between the line of sight and the floor's normal.
Camera tilted(Camera camera, double tilt_deg) {
    const double distance = glm::distance(camera.position, camera.target);
    const double tilt = tilt_deg * std::numbers::pi / 180;
    camera.position = camera.target + distance * glm::dvec3(0, std::cos(tilt), std::sin(tilt));
    camera.up = {0, std::sin(tilt), -std::cos(tilt)};
    return camera;
}

// Whether the picture's surface hides a point of a ray from `position`: nearer to the eye, and higher above
// the tangent plane where the line of sight runs toward it.
bool hides(const Picture& picture, const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 image = picture.frame.project(point);
    const double x = std::floor(image.x), y = std::floor(image.y);
    if (x < 0 || y < 0 || x >= picture.frame.width() || y >= picture.frame.height()) return false;
    const auto depth =
        static_cast<double>(picture.images.linear_depth().at(static_cast<int>(x), static_cast<int>(y)));
    const glm::dvec3 tap = picture.frame.view_position(x + 0.5, y + 0.5, depth);
    if (tap.z <= point.z) return false;
    return glm::dot(tap, normal) >= 0 || glm::dot(tap - point, normal) > 0;
}

double ray_march(const Picture& picture, const glm::dvec3& position, const glm::dvec3& normal) {
    const glm::dmat3 frame = oracle::basis(normal);
    return oracle::mean(400, [&](oracle::Random& random) {
        const glm::dvec3 step = frame * oracle::cosine_direction(random) * (kRadius / kSteps);
        const double shift = oracle::unit(random);
        for (int i = 0; i < kSteps; ++i) {
            if (hides(picture, position + step * (i + shift), normal)) return 0.0;
        }
        return 1.0;
    });
}

class EdgeOn : public ::testing::TestWithParam<double> {};

TEST_P(EdgeOn, RayMarchGivesWhatAFinerPictureGives) {
    const Scene scene = load_scene("yard");
    const Camera camera = tilted(scene.views.front().camera, GetParam());
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    const auto draw = [&](int size) {
        const CameraFrame frame(camera, size, size);
        renderer.draw_gbuffer(frame, gbuffer_inputs());
        return Picture{frame, renderer.read_gbuffer()};
    };
    const Picture fine = draw(kFiner * kSize), picture = draw(kSize);
    const auto methods = load_methods();
    MethodRequest request;
    request.method = &find_method(methods, "ray-march");
    request.parameters = request.method->values("solid", {{"radius", kRadius}, {"steps", kSteps}});
    const ImageF shader = renderer.run(request).raw;
    double squares = 0, count = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            if (picture.images.surface.at(x, y) == 0 || (7 * x + 13 * y) % 61 != 0) continue;
            const double depth = static_cast<double>(picture.images.linear_depth().at(x, y));
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(picture.images.vector("normal_geometric").at(x, y)));
            const double expected =
                ray_march(fine, picture.frame.view_position(x + 0.5, y + 0.5, depth), normal);
            squares += std::pow(static_cast<double>(shader.at(x, y)) - expected, 2);
            ++count;
        }
    }
    const double rms = std::sqrt(squares / count);
    std::printf("tilt %g: RMS %.4f over %g pixels\n", GetParam(), rms, count);
    EXPECT_LT(rms, 0.06);
}

INSTANTIATE_TEST_SUITE_P(Tilts, EdgeOn, ::testing::Values(60.0, 85.0, 88.0), [](const auto& tested) {
    return "of_" + std::to_string(static_cast<int>(tested.param)) + "_degrees";
});

}  // namespace
}  // namespace aoscore::testing
