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
    const Timing timing = summarize(std::vector<double>());
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
    const auto runs = [](double ms) { return PassRuns{{ms, ms + 1}, {2 * ms, 2 * ms + 1}}; };
    const StoredTimes times{runs(1),  runs(3),      runs(5),  runs(7), runs(9),
                            runs(11), {13.5, 14.5}, runs(15), 1024};
    const StoredTimes back = stored_times_from_json(to_json(times), "test");
    for (const auto pass :
         {&StoredTimes::ao, &StoredTimes::filter, &StoredTimes::fixed_pass, &StoredTimes::lighting,
          &StoredTimes::frame_at_once, &StoredTimes::frame_by_pass, &StoredTimes::gbuffer}) {
        EXPECT_EQ((back.*pass).ms, (times.*pass).ms);
        EXPECT_EQ((back.*pass).processor_ms, (times.*pass).processor_ms);
    }
    EXPECT_EQ(back.layers_processor_ms, times.layers_processor_ms);
    EXPECT_EQ(back.gbuffer_bytes, times.gbuffer_bytes);
}

}  // namespace
}  // namespace aoscore
