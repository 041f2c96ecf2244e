#include "screen/gbuffer/capture.h"

#include "core/error.h"
#include "hand_made.h"

#include <gtest/gtest.h>

#include <array>

namespace aoscore::testing {
namespace {

constexpr int kSide = 33;

/// Planes that face the camera at 2, 4 and 8 m, the first over the left half of the picture alone.
Scene three_planes() {
    Scene scene = empty_scene();
    add_quad(scene, {-20, -20, -2}, {20, 0, 0}, {0, 40, 0});
    add_quad(scene, {-20, -20, -4}, {40, 0, 0}, {0, 40, 0});
    add_quad(scene, {-20, -20, -8}, {40, 0, 0}, {0, 40, 0});
    return scene;
}

CameraFrame camera_at(double x) {
    Camera camera = front_camera();
    camera.position.x = x;
    camera.target.x = x;
    return CameraFrame(camera, kSide, kSide);
}

float depth_at(ScreenRenderer& renderer, const CaptureIndex& index, int x) {
    return renderer.read_gbuffer(index).linear_depth().at(x, kSide / 2);
}

TEST(Capture, PeelsLayersOffFrontToBack) {
    ScreenRenderer renderer;
    renderer.set_scene(three_planes());
    Capture capture(camera_at(0), {"normal_geometric"});
    capture.layers = 4;
    renderer.draw_gbuffer(capture);
    const auto far = static_cast<float>(front_camera().far);
    const std::array<float, 4> left = {2, 4, 8, far}, right = {4, 8, far, far};
    for (int layer = 0; layer < 4; ++layer) {
        const auto i = static_cast<std::size_t>(layer);
        EXPECT_NEAR(depth_at(renderer, {.layer = layer}, 4), left[i], 1e-4F * left[i]) << layer;
        EXPECT_NEAR(depth_at(renderer, {.layer = layer}, kSide - 4), right[i], 1e-4F * right[i]) << layer;
    }
}

TEST(Capture, HasAPictureForEachFrameAndEyeOfItsOwnCamera) {
    ScreenRenderer renderer;
    renderer.set_scene(three_planes());
    // The capture has two frames of two eyes; the edge of the near plane lies at x = 0.
    Capture capture(camera_at(-30), {});
    for (const double x : {30.0, 1.0, -1.0}) capture.cameras.push_back(camera_at(x));
    capture.eyes = 2;
    EXPECT_EQ(capture.frames(), 2);
    EXPECT_EQ(capture.pictures(), 4U);
    renderer.draw_gbuffer(capture);
    const auto middle = [&](int frame, int eye) {
        return depth_at(renderer, {.frame = frame, .eye = eye}, kSide / 2);
    };
    const auto far = static_cast<float>(front_camera().far);
    EXPECT_EQ(middle(0, 0), far) << "left of all planes";
    EXPECT_EQ(middle(0, 1), far) << "right of all planes";
    EXPECT_NEAR(middle(1, 0), 4, 1e-3);
    EXPECT_NEAR(middle(1, 1), 2, 1e-3);
}

TEST(Capture, OfMoreThanOnePictureChangesNothingOfTheFirst) {
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    const CameraFrame frame(corner_camera(), 96, 54);
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    const GBufferImages alone = renderer.read_gbuffer();
    Capture capture(frame, gbuffer_inputs());
    capture.cameras.push_back(CameraFrame(front_camera(), 96, 54));
    capture.layers = 2;
    renderer.draw_gbuffer(capture);
    const GBufferImages first = renderer.read_gbuffer();
    EXPECT_EQ(first.surface.pixels, alone.surface.pixels);
    for (const auto& [channel, image] : alone.numbers) EXPECT_EQ(first.number(channel).pixels, image.pixels);
    for (const auto& [channel, image] : alone.vectors) EXPECT_EQ(first.vector(channel).pixels, image.pixels);
}

TEST(Capture, RefusesCamerasOfSeveralSizesAndUnknownChannels) {
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    Capture capture(camera_at(0), {});
    capture.cameras.push_back(CameraFrame(front_camera(), kSide, kSide + 1));
    EXPECT_THROW(renderer.draw_gbuffer(capture), Error);
    EXPECT_THROW(renderer.draw_gbuffer(camera_at(0), {"depth"}), Error);
}

}  // namespace
}  // namespace aoscore::testing
