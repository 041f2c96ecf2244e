// Tests the camera that just shows some points against closed forms.
#include "framing/outline_fit.h"

#include "framing/spread_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using aoscore::Camera;
using aoscore::CameraFrame;
using aoscore::fit_outline;

constexpr double kRightAngle = std::numbers::pi / 2;

TEST(OutlineFit, OfABallStandsItsRadiusOverTheSineOfHalfTheAngleAway) {
    std::vector<glm::dvec3> points;
    constexpr int kPoints = 100'000;
    const glm::dvec3 centre(3, -2, 5);
    for (int i = 0; i < kPoints; ++i)
        points.push_back(centre + 2.0 * aoscore::spread_direction({0, 1, 0}, -1, i, kPoints));
    for (const double fovy : {0.3, 1.0, 2.0}) {
        const glm::dvec3 forward = glm::normalize(glm::dvec3(1, -0.7, 0.4));
        const Camera camera = fit_outline(points, forward, {0, 1, 0}, fovy, 16.0 / 9, 0);
        EXPECT_NEAR(glm::distance(camera.position, centre), 2 / std::sin(fovy / 2), 1e-3);
        EXPECT_NEAR(glm::dot(glm::normalize(centre - camera.position), forward), 1, 1e-6);
    }
}

TEST(OutlineFit, OfABoxTouchesItsNearestFace) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1) != 0 ? 3 : 1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    // Along -z the face at z = 1 is 2 high: at 90 degrees the camera stands half of that before it.
    const Camera tall = fit_outline(corners, {0, 0, -1}, {0, 1, 0}, kRightAngle, 2, 0);
    EXPECT_NEAR(glm::distance(tall.position, glm::dvec3(2, 0, 2)), 0, 1e-12);
    // In a picture half as wide as it is high, the sides touch.
    const Camera wide = fit_outline(corners, {0, 0, -1}, {0, 1, 0}, kRightAngle, 0.5, 0);
    EXPECT_NEAR(glm::distance(wide.position, glm::dvec3(2, 0, 3)), 0, 1e-12);
    const Camera free = fit_outline(corners, {0, 0, -1}, {0, 1, 0}, kRightAngle, 2, 0.2);
    EXPECT_NEAR(glm::distance(free.position, glm::dvec3(2, 0, 1 + 1 / 0.8)), 0, 1e-12);
}

TEST(OutlineFit, ShowsEveryPointAndTouchesTwoSides) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 50; ++i)
        points.push_back(glm::dvec3(7, 1, 2) * aoscore::spread_direction({0, 0, 1}, -1, i * 13 % 50, 50) +
                         glm::dvec3(i % 7, i % 5, i % 3));
    Camera camera =
        fit_outline(points, glm::normalize(glm::dvec3(-1, -0.5, -0.3)), {0, 1, 0}, 0.8, 16.0 / 9, 0);
    camera.near = 1e-3;
    const CameraFrame frame(camera, 1600, 900);
    double left = 1600, right = 0, top = 900, bottom = 0;
    for (const glm::dvec3& p : points) {
        const glm::dvec3 image = frame.project(glm::dvec3(frame.view_from_world() * glm::dvec4(p, 1)));
        EXPECT_GT(image.z, 0);
        left = std::min(left, image.x);
        right = std::max(right, image.x);
        top = std::min(top, image.y);
        bottom = std::max(bottom, image.y);
    }
    EXPECT_GE(left, -1e-6);
    EXPECT_LE(right, 1600 + 1e-6);
    EXPECT_GE(top, -1e-6);
    EXPECT_LE(bottom, 900 + 1e-6);
    EXPECT_TRUE((left < 1e-6 && right > 1600 - 1e-6) || (top < 1e-6 && bottom > 900 - 1e-6));
}

}  // namespace
