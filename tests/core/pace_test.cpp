#include "core/pace.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

Pace guess() {
    return {.fixed_s = 0.3, .unit_s = 2};
}

TEST(Pace, OfNothingIsTheGuess) {
    EXPECT_NEAR(guess().predicted_s(0), 0.3, 1e-12);
    EXPECT_NEAR(guess().predicted_s(2), 4.3, 1e-12);
}

TEST(Pace, FindsFixedAndGrowingTimeFromTwoSizes) {
    Pace pace = guess();
    for (int i = 0; i < 20; ++i) {
        pace.observe(0.1, 1 + 0.1 * 3);
        pace.observe(2, 1 + 2 * 3);
    }
    for (const double size : {0.1, 1.0, 4.0}) EXPECT_NEAR(pace.predicted_s(size), 1 + 3 * size, 0.15) << size;
}

// A small picture takes mostly fixed time. Taken as growing, a picture a thousand times as large would seem
// to take a thousand times as long: 500 s.
TEST(Pace, OfASmallPictureAloneSaysLittleOfALargeOne) {
    Pace pace = guess();
    pace.observe(0.002, 0.5);
    EXPECT_NEAR(pace.predicted_s(0.002), 0.5, 0.02);
    EXPECT_LT(pace.predicted_s(2), 6);
    EXPECT_GT(pace.predicted_s(2), 3);
}

TEST(Pace, ForgetsASlowDay) {
    Pace pace = guess();
    for (int i = 0; i < 5; ++i) pace.observe(1, 100);
    for (int i = 0; i < 12; ++i) pace.observe(1, 2);
    EXPECT_NEAR(pace.predicted_s(1), 2, 0.2);
}

TEST(Pace, IsNeverBelowZero) {
    Pace shrinking = guess(), late = guess();
    for (int i = 0; i < 5; ++i) {
        shrinking.observe(1, 5);
        shrinking.observe(2, 1);
        late.observe(1, 0);
        late.observe(2, 10);
    }
    for (const double size : {0.0, 0.5, 1.0, 10.0}) {
        EXPECT_GE(shrinking.predicted_s(size), 0) << size;
        EXPECT_GE(late.predicted_s(size), 0) << size;
    }
}

}  // namespace
}  // namespace aoscore
