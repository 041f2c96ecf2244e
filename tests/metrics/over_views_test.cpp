#include "metrics/intervals/over_views.h"

#include "core/error.h"
#include "metrics/evaluate.h"
#include "metrics/intervals/bootstrap.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace aoscore {
namespace {

TEST(OverViews, OneViewIsItselfAndEqualViewsAreOne) {
    for (const Metric& metric : metrics()) {
        const std::array<double, 1> one{0.3};
        const std::array<double, 3> equal{0.3, 0.3, 0.3};
        EXPECT_EQ(metric.over_views(one), 0.3) << metric.id;
        EXPECT_NEAR(metric.over_views(equal), 0.3, 1e-15) << metric.id;
        EXPECT_EQ(measure_over_views(metric.id, one), 0.3) << metric.id;
    }
}

// Two pictures of one size side by side are one picture: metrics made of sums have its value.
TEST(OverViews, TwoViewsAreThePictureOfBoth) {
    testing::Pair left = testing::natural_pair(40, 30), right = testing::natural_pair(40, 30, 9),
                  both(80, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            right.test.at(x, y) = 0.5F * right.test.at(x, y);
            both.truth.at(x, y) = left.truth.at(x, y);
            both.test.at(x, y) = left.test.at(x, y);
            both.truth.at(x + 40, y) = right.truth.at(x, y);
            both.test.at(x + 40, y) = right.test.at(x, y);
        }
    }
    const ImageF half_error(40, 30, 0.01F), error(80, 30, 0.01F);
    for (const char* id : {"rmse", "rmse_debiased", "mae", "bias", "psnr", "max_error"}) {
        const Metric& metric = aoscore::metric(id);
        const std::array<double, 2> values{*metric.measure(left.input(&half_error)).value,
                                           *metric.measure(right.input(&half_error)).value};
        EXPECT_GT(std::abs(values[0] - values[1]), 1e-3) << id;
        EXPECT_NEAR(measure_over_views(id, values), *metric.measure(both.input(&error)).value, 1e-9) << id;
    }
}

TEST(OverViews, HoldEveryMeasureThatIsResampledAndNoOther) {
    const std::array<double, 2> values{0.1, 0.3};
    for (const std::string& id : bootstrap_measures()) EXPECT_NO_THROW(measure_over_views(id, values)) << id;
    EXPECT_DOUBLE_EQ(measure_over_views(kMissingArea, values), 0.2);
    EXPECT_DOUBLE_EQ(measure_over_views("rmse", values), std::sqrt(0.05));
    EXPECT_THROW(measure_over_views("beauty", values), Error);
}

}  // namespace
}  // namespace aoscore
