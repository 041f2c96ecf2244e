#include "core/rough_text.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(RoughText, SaysDurationsInTheUnitThatFits) {
    EXPECT_EQ(rough_duration(0.01), "1 s");
    EXPECT_EQ(rough_duration(36.4), "36 s");
    EXPECT_EQ(rough_duration(110), "2 min");
    EXPECT_EQ(rough_duration(12000), "3 h");
    EXPECT_EQ(rough_duration(4 * 86400), "4 d");
}

TEST(RoughText, SaysNumbersWithTwoDigitsThatCountAndWithoutExponents) {
    EXPECT_EQ(rough_number(1), "1");
    EXPECT_EQ(rough_number(81.3), "81");
    EXPECT_EQ(rough_number(99.7), "100");
    EXPECT_EQ(rough_number(352), "350");
    EXPECT_EQ(rough_number(4.04e6), "4000000");
}

}  // namespace
}  // namespace aoscore
