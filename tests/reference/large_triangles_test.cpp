#include "reference/integrator/early_out_predictor.h"
#include "reference/test_scenes.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace aoscore {
namespace {

class FarRays : public ::testing::TestWithParam<std::string> {};

TEST_P(FarRays, ThatAskWallsFirstGiveTheSameBits) {
    const Scene scene = load_scene(GetParam());
    const ReferenceScene reference(scene);
    for (const View& view : scene.views) {
        const CameraFrame frame(view.camera, 96, 54);
        for (const double radius_m : {scene.bounds.diagonal() / 4, double{INFINITY}}) {
            TruthSettings settings;
            settings.samples = 64;
            const std::vector<TruthQuery> query = {{Falloff::binary, radius_m, 0}};
            const Truth asked = reference.trace(frame, query, settings, "largest triangles first");
            settings.large_triangles_first = false;
            const Truth not_asked = reference.trace(frame, query, settings, "whole scene");
            EXPECT_EQ(asked.visibility[0].pixels, not_asked.visibility[0].pixels) << view.id << radius_m;
            EXPECT_EQ(asked.standard_error[0].pixels, not_asked.standard_error[0].pixels)
                << view.id << radius_m;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, FarRays, ::testing::Values("atrium", "cathedral", "sphere"),
                         [](const auto& tested) { return tested.param; });

TEST(FarRays, FindWallsOnlyInScenesWithManyMoreTriangles) {
    EXPECT_NE(new_ray_tracer(load_scene("atrium"), {})->large_triangles(), nullptr);
    EXPECT_EQ(new_ray_tracer(testing::still_life(), {})->large_triangles(), nullptr);
}

TEST(FarRays, StopTryingLargeTrianglesThatTheyPass) {
    EarlyOutPredictor predictor;
    EXPECT_TRUE(predictor.worth_it()) << "nothing is known yet";
    predictor.learn(1000, 950);
    EXPECT_TRUE(predictor.worth_it());
    predictor.learn(1000, 100);
    EXPECT_FALSE(predictor.worth_it());
}

}  // namespace
}  // namespace aoscore
