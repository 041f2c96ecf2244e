// How much work goes into the tree that rays are traced in.
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace aoscore {
namespace {

TEST(TreeEffort, IsSparedWhereFewRaysWouldNotRepayIt) {
    constexpr double kManyRays = 1920.0 * 1080 * 64;
    EXPECT_EQ(tree_effort(1'000'000, 640.0 * 360 * 16), TreeEffort::quick);
    EXPECT_EQ(tree_effort(1'000'000, kManyRays), TreeEffort::thorough);
    EXPECT_EQ(tree_effort(10'000'000, kManyRays), TreeEffort::quick);
    EXPECT_EQ(tree_effort(1'000'000'000, std::numeric_limits<double>::infinity()), TreeEffort::thorough);
}

TEST(TreeEffort, ChangesNoBitOfATruth) {
    const Scene scene = load_scene("cathedral");
    const View& view = scene.views.front();
    const CameraFrame frame(view.camera, 96, 54);
    TruthSettings settings;
    settings.samples = 32;
    std::uint64_t triangles = 0;
    for (const Instance& instance : scene.instances)
        triangles += scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
    ASSERT_EQ(tree_effort(triangles, 96.0 * 54 * settings.samples), TreeEffort::quick);
    const ReferenceScene thorough(scene), quick = ReferenceScene::built_when_needed(scene);
    for (const double radius_m : {0.5, std::numeric_limits<double>::infinity()}) {
        const std::vector<TruthQuery> queries = {{Falloff::binary, radius_m, 0},
                                                 {Falloff::quadratic, radius_m < 1 ? radius_m : 5, 0}};
        const Truth a = thorough.trace(frame, queries, settings, "thorough");
        const Truth b = quick.trace(frame, queries, settings, "quick");
        EXPECT_EQ(a.hits.depth.pixels, b.hits.depth.pixels);
        for (std::size_t q = 0; q < queries.size(); ++q) {
            EXPECT_EQ(a.visibility[q].pixels, b.visibility[q].pixels);
            EXPECT_EQ(a.standard_error[q].pixels, b.standard_error[q].pixels);
        }
    }
}

}  // namespace
}  // namespace aoscore
