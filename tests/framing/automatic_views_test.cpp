// Tests the cameras that a scene without any gets.
#include "framing/automatic_views.h"

#include "core/threads.h"
#include "made_scene.h"
#include "reference/tracer/scout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using aoscore::automatic_views;
using aoscore::CameraFrame;
using aoscore::Scene;
using aoscore::View;
using aoscore::testing::MadeScene;

constexpr double kAspect = 16.0 / 9;

MadeScene still_life() {
    return MadeScene()
        .box({-1, 0, -1}, {1, 0.2, 1})
        .box({-0.5, 0.2, -0.3}, {0.1, 1, 0.4})
        .ball({0.5, 0.5, 0.4}, 0.3);
}

/// A hall, long in z, with a block in it and a gallery on one side.
MadeScene hall() {
    return MadeScene()
        .box({0, 0, 0}, {6, 4, 20}, true)
        .box({2, 0, 13}, {4, 3, 15})
        .box({0, 2.4, 4}, {1.5, 2.6, 12});
}

double coverage(const Scene& scene, const View& view) {
    return aoscore::Scout(scene).look(CameraFrame(view.camera, 192, 108), 1, 0).coverage();
}

TEST(AutomaticViews, OfAnObjectShowAllOfItFromTwoSides) {
    const Scene scene = still_life().made();
    const std::vector<View> views = automatic_views(scene, kAspect);
    ASSERT_EQ(views.size(), 2u);
    for (const View& view : views) {
        EXPECT_EQ(view.kind, View::Kind::automatic);
        const CameraFrame frame(view.camera, 160, 90);
        glm::dvec2 low(160), high(0);
        for (const glm::vec3& p : scene.meshes[0].positions) {
            const glm::dvec3 image = frame.project(glm::dvec3(frame.view_from_world() * glm::dvec4(p, 1)));
            low = glm::min(low, glm::dvec2(image));
            high = glm::max(high, glm::dvec2(image));
            EXPECT_GE(image.z, view.camera.near);
            EXPECT_LE(image.z, view.camera.far);
        }
        // The picture is as large as the margin of 2 % on each side allows: two sides touch it.
        EXPECT_TRUE(low.x > 3.2 - 1e-6 && high.x < 156.8 + 1e-6 && low.y > 1.8 - 1e-6 &&
                    high.y < 88.2 + 1e-6);
        EXPECT_TRUE((low.x < 3.2 + 1e-6 && high.x > 156.8 - 1e-6) ||
                    (low.y < 1.8 + 1e-6 && high.y > 88.2 - 1e-6));
    }
    const glm::dvec3 a = views[0].camera.target - views[0].camera.position;
    const glm::dvec3 b = views[1].camera.target - views[1].camera.position;
    EXPECT_LT(glm::dot(glm::normalize(a), glm::normalize(b)), 0.7);
    EXPECT_LT(a.y, 0) << "looked at from above";
}

TEST(AutomaticViews, AreTheSameWithAStrayTriangleAHundredTimesAsFarAway) {
    const Scene plain = still_life().made();
    const Scene strayed =
        still_life().triangle({200, 300, 150}, {200.01, 300, 150}, {200, 300.01, 150}).made();
    ASSERT_GT(strayed.bounds.diagonal(), 100 * plain.bounds.diagonal());
    const std::vector<View> a = automatic_views(plain, kAspect), b = automatic_views(strayed, kAspect);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].camera.position, b[i].camera.position);
        EXPECT_EQ(a[i].camera.target, b[i].camera.target);
        EXPECT_EQ(a[i].radius_m, b[i].radius_m);
    }
}

TEST(AutomaticViews, DoNotDependOnTheUnitOfLength) {
    for (const MadeScene& made : {still_life(), hall()}) {
        const std::vector<View> metres = automatic_views(made.made(), kAspect);
        for (const double scale : {1.0 / 1024, 1e-3, 0.0254, 1e3}) {
            const bool exact = std::exp2(std::round(std::log2(scale))) == scale;
            const std::vector<View> scaled = automatic_views(made.made(scale), kAspect);
            ASSERT_EQ(scaled.size(), metres.size());
            for (std::size_t i = 0; i < metres.size(); ++i) {
                const double size = glm::distance(metres[i].camera.position, metres[i].camera.target);
                const double tolerance = exact ? 0 : 1e-5 * size;
                EXPECT_LE(glm::distance(scaled[i].camera.position / scale, metres[i].camera.position),
                          tolerance);
                EXPECT_LE(glm::distance(scaled[i].camera.target / scale, metres[i].camera.target), tolerance);
                EXPECT_LE(std::abs(*scaled[i].radius_m / scale - *metres[i].radius_m), exact ? 0 : 1e-5);
            }
        }
    }
}

TEST(AutomaticViews, OfARoomAreSeatsInItsAir) {
    const std::vector<View> views = automatic_views(hall().made(), kAspect);
    ASSERT_EQ(views.size(), 3u);
    for (const View& view : views) {
        const glm::dvec3 p = view.camera.position;
        EXPECT_TRUE(p.x > 0 && p.x < 6 && p.y > 0 && p.y < 4 && p.z > 0 && p.z < 20);
        EXPECT_FALSE(p.x > 2 && p.x < 4 && p.y < 3 && p.z > 13 && p.z < 15) << "within the block";
        EXPECT_EQ(coverage(hall().made(), view), 1) << "a closed room fills the picture";
    }
}

TEST(AutomaticViews, OfARoomWoundTheWrongWayRoundHaveSeatsToo) {
    const Scene scene = MadeScene()
                            .box({0, 0, 0}, {6, 3, 6})
                            .box({1, 0, 1}, {2.5, 2, 2.5})
                            .box({3.5, 0, 3}, {5, 1.5, 5})
                            .box({0.5, 0, 4}, {2, 2.2, 5.5})
                            .made();
    const std::vector<View> views = automatic_views(scene, kAspect);
    const auto is_within = [](const View& view) {
        const glm::dvec3 p = view.camera.position;
        return p.x > 0 && p.x < 6 && p.y > 0 && p.y < 3 && p.z > 0 && p.z < 6;
    };
    EXPECT_GE(std::ranges::count_if(views, is_within), 2);
}

TEST(AutomaticViews, OfARoomWithAnOpenSideLookThroughIt) {
    // Walls around 4 x 4 x 4, open towards +x, with two blocks.
    const Scene scene = MadeScene()
                            .box({0, -0.1, 0}, {4, 0, 4})
                            .box({0, 4, 0}, {4, 4.1, 4})
                            .box({-0.1, 0, 0}, {0, 4, 4})
                            .box({0, 0, -0.1}, {4, 4, 0})
                            .box({0, 0, 4}, {4, 4, 4.1})
                            .box({0.8, 0, 0.6}, {2, 2.6, 1.8})
                            .box({2.2, 0, 2.2}, {3.4, 1.2, 3.4})
                            .made();
    const View view = automatic_views(scene, kAspect).front();
    EXPECT_EQ(view.id, "auto_outside");
    EXPECT_GT(view.camera.position.x, 4);
    EXPECT_LT(glm::normalize(view.camera.target - view.camera.position).x, -0.7);
}

TEST(AutomaticViews, SayByWhichRuleTheirRadiusWasFound) {
    for (const View& view : automatic_views(still_life().made(), kAspect)) {
        EXPECT_EQ(aoscore::automatic_radius_rule(view), "2 % of the diagonal of the scene's main part");
        EXPECT_NEAR(*view.radius_m, 0.02 * std::sqrt(4 + 1 + 4), 1e-6);
    }
}

TEST(AutomaticViews, OfABallCoverWhatItsOutlineDoes) {
    // Up to perspective, the outline is a circle as high as the picture without its margins.
    const Scene scene = MadeScene().ball({4, 5, 6}, 2).made();
    for (const View& view : automatic_views(scene, kAspect))
        EXPECT_NEAR(coverage(scene, view), M_PI / 4 * 0.96 * 0.96 / kAspect, 0.01);
}

TEST(AutomaticViews, OfFlatAndTinyShapesExist) {
    const double s = 3;
    const std::vector<MadeScene> shapes{
        MadeScene().triangle({0, 0, 0}, {s, 0, 0}, {0, 0, s}).triangle({s, 0, 0}, {s, 0, s}, {0, 0, s}),
        MadeScene().triangle({0, 0, 0}, {s, 0, 0}, {0, s, 0}),
        MadeScene().triangle({0, 0, 0}, {0, 0, s}, {0, s, 0}),
        MadeScene().triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}),
        MadeScene().triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}),
        MadeScene().box({1e6, 0, 0}, {1e6 + 1, 1, 1}),
    };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Scene scene = shapes[i].made();
        const std::vector<View> views = automatic_views(scene, kAspect);
        ASSERT_FALSE(views.empty()) << i;
        for (const View& view : views) EXPECT_NO_THROW(CameraFrame(view.camera, 16, 9)) << i;
        const bool has_area = i < 3 || i == 5;
        if (has_area) {
            EXPECT_GT(coverage(scene, views.front()), 0.1) << i;
        }
    }
}

TEST(AutomaticViews, DoNotDependOnTheThreadCount) {
    aoscore::set_thread_count(1);
    const std::vector<View> one = automatic_views(hall().made(), kAspect);
    aoscore::set_thread_count(2);
    const std::vector<View> two = automatic_views(hall().made(), kAspect);
    aoscore::set_thread_count(0);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].camera, two[i].camera);
}

TEST(Scout, TellsFrontsFromBacksAlsoInMirroredInstances) {
    Scene scene = MadeScene().box({-1, -1, -1}, {1, 1, 1}).made();
    for (const double mirror : {1.0, -1.0}) {
        scene.instances[0].scene_from_mesh = glm::dmat4(glm::dmat3(mirror));
        const aoscore::Scout scout(scene);
        const aoscore::Sight outside = scout.first_surface({3, 0.1, 0.2}, {-1, 0, 0});
        EXPECT_NEAR(outside.distance_m, 2, 1e-6);
        EXPECT_TRUE(outside.front);
        EXPECT_FALSE(scout.first_surface({0, 0.1, 0.2}, {-1, 0, 0}).front);
        EXPECT_EQ(scout.first_surface({3, 0, 0}, {1, 0, 0}).distance_m,
                  std::numeric_limits<double>::infinity());
    }
}

}  // namespace
