// Holds the search to functions whose least value is known.
#include "tuning/search.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

SearchAxis real_axis(const char* id, double low, double high, double published) {
    SearchAxis axis;
    axis.parameter = id;
    axis.low = low;
    axis.high = high;
    axis.published = published;
    return axis;
}

SearchAxis whole_axis(const char* id, double low, double high, double published) {
    SearchAxis axis = real_axis(id, low, high, published);
    axis.whole = true;
    return axis;
}

TEST(Search, FindsTheBottomOfABowlThatIsNotInItsMiddle) {
    const std::vector axes{real_axis("x", -3, 5, 0), real_axis("y", 0, 10, 1)};
    const SearchGoal goal{
        [](const Settings& s) { return std::pow(s[0] - 1.7, 2) + 3 * std::pow(s[1] - 8.2, 2); }, nullptr};
    const Settings best = best_settings(axes, goal, {0, 1}, {100, 100});
    EXPECT_NEAR(best[0], 1.7, 0.1);
    EXPECT_NEAR(best[1], 8.2, 0.1);
}

// The global search must leave the bowl that it begins in: the deeper one is at -2.
TEST(Search, LeavesAShallowBowlForADeeperOne) {
    const std::vector axes{real_axis("x", -4, 4, 2)};
    const SearchGoal goal{
        [](const Settings& s) { return std::pow(s[0] * s[0] - 4, 2) / 16 + 0.2 * (s[0] + 2); }, nullptr};
    EXPECT_NEAR(best_settings(axes, goal, {2}, {60, 60})[0], -2, 0.15);
}

// More of both is better, and their product is paid for: of all whole pairs within 30, 5 x 6 and 6 x 5 come
// nearest to the line x + y = 12 that the loss wants high.
TEST(Search, SpendsABudgetOfWholeNumbers) {
    const std::vector axes{whole_axis("x", 1, 20, 2), whole_axis("y", 1, 20, 2)};
    const SearchGoal goal{[](const Settings& s) { return 1 / s[0] + 1 / s[1]; },
                          [](const Settings& s) { return s[0] * s[1] / 30 - 1; }};
    const Settings best = best_settings(axes, goal, {2, 2}, {80, 40});
    EXPECT_EQ(best[0], std::round(best[0]));
    EXPECT_LE(best[0] * best[1], 30);
    EXPECT_NEAR(1 / best[0] + 1 / best[1], 1.0 / 5 + 1.0 / 6, 1e-12);
}

TEST(Search, PutsBackWhatDoesHarm) {
    const std::vector axes{real_axis("useful", 0, 1, 0.5), real_axis("harmful", 0, 1, 0)};
    // Any amount of the second costs more than a global search of few settings can tell from the first.
    const SearchGoal goal{[](const Settings& s) { return std::abs(s[0] - 0.9) + (s[1] > 0 ? 1 : 0); },
                          nullptr};
    EXPECT_EQ(best_settings(axes, goal, {0.5, 0}, {20, 20})[1], 0);
}

TEST(Search, RefusesABudgetThatNothingKeeps) {
    const std::vector axes{whole_axis("x", 4, 16, 8)};
    const SearchGoal goal{[](const Settings& s) { return s[0]; }, [](const Settings& s) { return s[0] - 1; }};
    EXPECT_THROW(best_settings(axes, goal, {8}, {20, 20}), Error);
}

TEST(Search, PassesOnWhatTheLossThrows) {
    const std::vector axes{real_axis("x", 0, 1, 0.5)};
    const SearchGoal goal{[](const Settings& s) -> double {
                              if (s[0] != 0.5) throw interrupted_error();
                              return 1;
                          },
                          nullptr};
    EXPECT_THROW(best_settings(axes, goal, {0.5}, {20, 20}), Error);
}

}  // namespace
}  // namespace aoscore
