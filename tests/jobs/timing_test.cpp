#include "jobs/timing.h"

#include "jobs/stored_times.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(Timing, MedianAndSpreadAreQuantilesOfTheRuns) {
    const Timing timing = summarize({5, 1, 3, 2, 4});
    EXPECT_DOUBLE_EQ(*timing.median_ms, 3);
    EXPECT_DOUBLE_EQ(*timing.spread_ms, 1);
    EXPECT_EQ(timing.runs_ms, (std::vector<double>{5, 1, 3, 2, 4}))
        << "runs are kept in the order they were taken";
}

TEST(Timing, WithoutRunsNothingIsClaimed) {
    const Timing timing = summarize({});
    EXPECT_FALSE(timing.median_ms);
    EXPECT_FALSE(timing.spread_ms);
}

TEST(Timing, SlowPassesGetThreeRunsOthersTen) {
    EXPECT_EQ(timed_runs(999), 10);
    EXPECT_EQ(timed_runs(1001), 3);
}

TEST(Timing, GroupsGrowWhileTheyAreQuickAndShrinkWhereTheyAreSlow) {
    EXPECT_EQ(next_group(kFirstGroup, 1), 8u);
    EXPECT_EQ(next_group(16, 1), 16u) << "no larger";
    EXPECT_EQ(next_group(8, 20), 8u);
    EXPECT_EQ(next_group(8, 60), 4u);
    EXPECT_EQ(next_group(kFirstGroup, 600), kFirstGroup) << "a group of few is no group";
}

TEST(StoredTimes, SurviveTheStore) {
    const StoredTimes times{{1.5, 2.5}, {0.25},     3.0,    {4.5},  {5.5},
                            {6.5, 7.5}, {8.5, 9.5}, {10.5}, {11.5}, 1024};
    const StoredTimes back = stored_times_from_json(to_json(times), "test");
    EXPECT_EQ(back.ao_ms, times.ao_ms);
    EXPECT_EQ(back.filter_ms, times.filter_ms);
    EXPECT_EQ(back.fixed_pass_ms, times.fixed_pass_ms);
    EXPECT_EQ(back.lighting_ms, times.lighting_ms);
    EXPECT_EQ(back.frame_at_once_ms, times.frame_at_once_ms);
    EXPECT_EQ(back.frame_by_pass_ms, times.frame_by_pass_ms);
    EXPECT_EQ(back.ao_processor_ms, times.ao_processor_ms);
    EXPECT_EQ(back.layers_processor_ms, times.layers_processor_ms);
    EXPECT_EQ(back.gbuffer_ms, times.gbuffer_ms);
    EXPECT_EQ(back.gbuffer_bytes, times.gbuffer_bytes);
}

}  // namespace
}  // namespace aoscore
