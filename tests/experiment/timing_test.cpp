#include "experiment/timing.h"

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

}  // namespace
}  // namespace aoscore
