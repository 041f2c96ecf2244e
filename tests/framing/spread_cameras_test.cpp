// Cameras for a search stand in the open, see surfaces, and differ.
#include "framing/spread_cameras.h"

#include "core/hash.h"
#include "made_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace aoscore {
namespace {

struct Spread {
    Scene scene;
    Scout scout;
    MainPart main;
    SpreadCameras found;

    explicit Spread(const char* id, std::optional<double> height_m = {})
        : scene(load_scene(id)),
          scout(scene),
          main(main_part(scene)),
          found(spread_cameras({scout, main, 0.02 * main.bounds.diagonal(), 16.0 / 9, scene.bounds}, 60,
                               height_m)) {}
};

class SpreadOver : public ::testing::TestWithParam<const char*> {};

// Looked at again with ten times the pixels.
TEST_P(SpreadOver, SeeSurfacesFromPlacesInTheOpen) {
    const Spread spread(GetParam());
    ASSERT_GE(spread.found.cameras.size(), 12U);
    EXPECT_EQ(spread.found.tried, 60U);
    for (const Candidate& candidate : spread.found.cameras) {
        const Glance glance = spread.scout.look(CameraFrame(candidate.camera, 152, 86), 0.1, 1);
        EXPECT_GT(glance.coverage(), 0.35);
        std::size_t fronts = 0;
        for (const Glance::Point& point : glance.points) fronts += point.front ? 1 : 0;
        EXPECT_GT(fronts, glance.points.size() / 3) << "in a solid most surfaces show their back";
    }
}

TEST_P(SpreadOver, AreTheSameEachTimeAndNoTwoAreOne) {
    const Spread first(GetParam()), again(GetParam());
    ASSERT_EQ(first.found.cameras.size(), again.found.cameras.size());
    std::set<std::string> different;
    for (std::size_t i = 0; i < first.found.cameras.size(); ++i) {
        const Camera &a = first.found.cameras[i].camera, &b = again.found.cameras[i].camera;
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.target, b.target);
        Digest digest;
        digest.value(a.position).value(a.target);
        different.insert(digest.hex());
    }
    EXPECT_EQ(different.size(), first.found.cameras.size());
}

INSTANTIATE_TEST_SUITE_P(Scenes, SpreadOver, ::testing::Values("atrium", "cathedral", "railing"),
                         [](const auto& tested) { return std::string(tested.param); });

// Beside a board a place sees surfaces in most directions, and is no room for that.
TEST(SpreadCameras, LookAtABoardOnAFloorFromOutside) {
    const Scene scene =
        testing::MadeScene().box({-3, -0.2, -3}, {3, 0, 3}).box({-2, 0, -0.01}, {2, 1.5, 0.01}).made();
    const Scout scout(scene);
    const MainPart main = main_part(scene);
    const SpreadCameras found = spread_cameras({scout, main, 1, 16.0 / 9, scene.bounds}, 60, {});
    EXPECT_FALSE(found.inside);
    EXPECT_GE(found.cameras.size(), 12U);
}

TEST(SpreadCameras, StandAtEyeLevelAboveTheFloorWhereAskedTo) {
    const Spread spread("cathedral", 1.7);
    ASSERT_TRUE(spread.found.inside);
    for (const Candidate& candidate : spread.found.cameras) {
        const Sight down = spread.scout.first_surface(candidate.camera.position, {0, -1, 0});
        EXPECT_NEAR(down.distance_m, 1.7, 1e-4);
    }
}

}  // namespace
}  // namespace aoscore
