#include "metrics/measures/power.h"

#include "core/srgb.h"
#include "metrics/measures/power_of_lanes.h"
#include "metrics/measures/srgb_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace aoscore {
namespace {

std::vector<double> values_of_all_sizes() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-60, 9);
    std::vector<double> values{1, 1e-98, 1e9, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)};
    for (int i = 0; i < 20000; ++i) values.push_back(std::pow(10, exponent(random)));
    return values;
}

TEST(Raise, AgreesWithTheLibraryToThirteenDigits) {
    for (const double exponent : {0.0, 1.0 / 3, 0.5, 0.7, 1.0, 2.4, 3.0}) {
        const std::vector<double> values = values_of_all_sizes();
        std::vector<double> raised = values;
        raise(raised, exponent);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto exact = static_cast<double>(
                powl(static_cast<long double>(values[i]), static_cast<long double>(exponent)));
            ASSERT_NEAR(raised[i] / exact, 1, 1e-13) << values[i] << " to the power of " << exponent;
        }
    }
}

TEST(Raise, OfZeroIsZeroButForTheExponentZero) {
    std::vector<double> values(9, 0.0);
    raise(values, 0.3);
    EXPECT_EQ(values, std::vector<double>(9, 0.0));
    values[3] = 0.5;
    raise(values, 0);
    EXPECT_EQ(values, std::vector<double>(9, 1.0));
}

TEST(Roots, AgreeWithTheLibraryToFourteenDigits) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> log2(-12, 0);
    for (int i = 0; i < 100000; ++i) {
        const double x = std::exp2(log2(random));
        const auto wide = static_cast<long double>(x);
        ASSERT_NEAR(cube_root(x) / static_cast<double>(cbrtl(wide)), 1, 1e-14) << x;
        ASSERT_NEAR(to_the_2_4(x) / static_cast<double>(powl(wide, 2.4L)), 1, 1e-14) << x;
    }
}

TEST(SrgbValues, FollowTheCurveOfOneValue) {
    std::vector<double> coded;
    for (int i = 0; i <= 5000; ++i) coded.push_back(i / 5000.0);
    for (const double knee : {0.04045, 0.0031308}) {
        for (const double beside : {0.0, 1.0}) coded.push_back(std::nextafter(knee, beside));
        coded.push_back(knee);
    }
    std::vector<double> off = coded, on = coded;
    take_srgb_off(off);
    put_srgb_on(on);
    for (std::size_t i = 0; i < coded.size(); ++i) {
        EXPECT_NEAR(off[i], linear_from_srgb(coded[i]), 1e-14) << coded[i];
        EXPECT_NEAR(on[i], srgb_from_linear(coded[i]), 1e-14) << coded[i];
    }
}

}  // namespace
}  // namespace aoscore
