#include "reference/integrator/tile_tracer.h"

#include "reference/test_scenes.h"
#include "reference/tile_points.h"
#include "reference/tracer/ray_tracer.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

TEST(TileTracer, SumsOfAPixelDoNotDependOnThoseThatAreTracedWithIt) {
    const auto scene = new_ray_tracer(testing::thicket(), {});
    for (const double radius_m : {0.1 * scene->diagonal_m() / 2, double{INFINITY}}) {
        for (const Falloff falloff : {Falloff::binary, Falloff::quadratic}) {
            if (falloff == Falloff::quadratic && std::isinf(radius_m)) continue;
            const std::vector<TruthQuery> queries = {{falloff, radius_m, 0}};
            const PointSets points(PointKind::scrambled_sobol, 2048);
            TileTracer together(*scene, queries, points, true), alone(*scene, queries, points, true);
            const std::vector<RaySource> sources =
                testing::tile_points(*scene, [](std::uint64_t) { return glm::dvec3(0, 1, 0); });
            together.start(sources);
            std::vector<SampleRange> ranges(sources.size(), {0, 64});
            together.trace(ranges);
            // Every third pixel has enough, as where an error is asked for.
            for (std::size_t s = 0; s < ranges.size(); ++s) ranges[s] = {64, s % 3 == 0 ? 64 : 2048};
            together.trace(ranges);
            double blocked = 0;
            for (std::size_t s = 0; s < sources.size(); ++s) {
                alone.start({sources[s]});
                alone.trace(std::vector<SampleRange>{{0, ranges[s].last}});
                EXPECT_TRUE(std::ranges::equal(together.sums(s, 0), alone.sums(0, 0))) << s;
                for (const double sum : alone.sums(0, 0)) blocked += sum;
            }
            EXPECT_GT(blocked, 1000) << "there is something to find";
        }
    }
}

TEST(TileTracer, SortsFewerPixelsTogetherTheMoreRaysTheyHaveAndTheLessFarTheseReach) {
    for (const double reach_m : {0.5, 50.0}) {
        std::size_t before = 64;
        for (int samples = 1; samples <= 4096; samples *= 2) {
            const std::size_t now = pixels_sorted_together(reach_m, 100, samples);
            EXPECT_LE(now, before);
            EXPECT_GE(now, 1u);
            EXPECT_LE(pixels_sorted_together(0.5, 100, samples), pixels_sorted_together(50, 100, samples));
            before = now;
        }
        EXPECT_LT(before, 64u);
    }
}

}  // namespace
}  // namespace aoscore
