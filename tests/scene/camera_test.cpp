#include "scene/camera.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using aoscore::Camera;
using aoscore::CameraFrame;

std::vector<Camera> cameras() {
    Camera perspective;
    perspective.position = {3, -2, 7};
    perspective.target = {-1, 4, 2};
    perspective.up = {0.1, 2, 0.3};
    perspective.fovy_rad = 1.1;
    perspective.near = 0.05;
    perspective.far = 80;
    Camera orthographic = perspective;
    orthographic.projection = Camera::Projection::orthographic;
    orthographic.half_height = 3.5;
    return {perspective, orthographic};
}

/// Image positions and depths, from a fixed seed.
struct Sample {
    double x, y, depth;
};
std::vector<Sample> samples(const Camera& camera, int width, int height) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Sample> result;
    for (int i = 0; i < 200; ++i) {
        const double depth = camera.near * std::pow(camera.far / camera.near, unit(random));
        result.push_back({unit(random) * width, unit(random) * height, depth});
    }
    return result;
}

constexpr int kWidth = 321, kHeight = 200;

TEST(CameraFrame, ProjectUndoesViewPosition) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        for (const Sample& s : samples(camera, kWidth, kHeight)) {
            const glm::dvec3 image = frame.project(frame.view_position(s.x, s.y, s.depth));
            EXPECT_NEAR(image.x, s.x, 1e-9);
            EXPECT_NEAR(image.y, s.y, 1e-9);
            EXPECT_NEAR(image.z, s.depth, 1e-12 * s.depth);
        }
    }
}

TEST(CameraFrame, RaysMeetTheViewPositionsOfTheirPixel) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        for (const Sample& s : samples(camera, kWidth, kHeight)) {
            const CameraFrame::Ray ray = frame.ray(s.x, s.y);
            const glm::dvec3 world = ray.origin + s.depth * ray.direction;
            const glm::dvec3 view(frame.view_from_world() * glm::dvec4(world, 1));
            EXPECT_LT(glm::distance(view, frame.view_position(s.x, s.y, s.depth)), 1e-11 * (1 + s.depth));
        }
    }
}

TEST(CameraFrame, ClipMatrixAgreesWithRaysAndWindowDepth) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        for (const Sample& s : samples(camera, kWidth, kHeight)) {
            const glm::dvec4 clip =
                frame.clip_from_view() * glm::dvec4(frame.view_position(s.x, s.y, s.depth), 1);
            const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
            EXPECT_NEAR((ndc.x + 1) / 2 * kWidth, s.x, 1e-9);
            EXPECT_NEAR((1 - ndc.y) / 2 * kHeight, s.y, 1e-9);
            EXPECT_NEAR((ndc.z + 1) / 2, frame.window_depth(s.depth), 1e-12);
        }
    }
}

TEST(CameraFrame, WindowDepthRunsFromNearToFarAndBack) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        EXPECT_NEAR(frame.window_depth(camera.near), 0, 1e-12);
        EXPECT_NEAR(frame.window_depth(camera.far), 1, 1e-12);
        for (const Sample& s : samples(camera, kWidth, kHeight)) {
            EXPECT_NEAR(frame.view_depth(frame.window_depth(s.depth)), s.depth, 1e-9 * s.depth);
        }
    }
}

TEST(CameraFrame, IsARotationWithoutMirror) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        EXPECT_NEAR(glm::determinant(glm::dmat3(frame.view_from_world())), 1, 1e-12);
        const glm::dmat4 product = frame.view_from_world() * frame.world_from_view();
        for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(product[i] - glm::dmat4(1.0)[i]), 1e-12);
        const glm::dvec3 target(frame.view_from_world() * glm::dvec4(camera.target, 1));
        EXPECT_NEAR(target.x, 0, 1e-12);
        EXPECT_NEAR(target.y, 0, 1e-12);
        EXPECT_LT(target.z, 0);
    }
}

TEST(CameraFrame, FirstPixelIsTopLeft) {
    Camera camera;  // a camera at the origin that looks down -z, y up
    const CameraFrame frame(camera, 4, 2);
    const glm::dvec3 direction = frame.ray(0.5, 0.5).direction;
    EXPECT_LT(direction.x, 0);
    EXPECT_GT(direction.y, 0);
    EXPECT_NEAR(direction.z, -1, 1e-15);
    // For even sizes a pixel's centre is half a pixel from the picture's middle.
    EXPECT_NEAR(frame.ray(2, 1).direction.x, 0, 1e-15);
}

TEST(CameraFrame, FootprintIsOnePixelOfHeight) {
    for (const Camera& camera : cameras()) {
        const CameraFrame frame(camera, kWidth, kHeight);
        for (const double depth : {0.1, 2.0, 50.0}) {
            const glm::dvec3 here = frame.view_position(100, 60, depth);
            const glm::dvec3 above = frame.project(here + glm::dvec3(0, frame.pixel_footprint(depth), 0));
            EXPECT_NEAR(above.y, 59, 1e-9);
            EXPECT_NEAR(frame.pixels_per_metre(depth) * frame.pixel_footprint(depth), 1, 1e-12);
        }
    }
}

TEST(CameraFrame, RefusesCamerasWithoutAPicture) {
    const auto refuses = [](void (*spoil)(Camera&)) {
        Camera camera;
        spoil(camera);
        EXPECT_THROW(CameraFrame(camera, 8, 8), aoscore::Error);
    };
    refuses([](Camera& c) { c.target = c.position; });
    refuses([](Camera& c) { c.up = c.target - c.position; });
    refuses([](Camera& c) { c.fovy_rad = std::numbers::pi; });
    refuses([](Camera& c) { c.near = 0; });
    refuses([](Camera& c) { c.far = c.near; });
    refuses([](Camera& c) { c.position.x = std::nan(""); });
    EXPECT_THROW(CameraFrame(Camera(), 0, 8), aoscore::Error);
}

}  // namespace
