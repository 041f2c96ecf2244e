#include "metrics/bootstrap.h"

#include "core/error.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <array>

namespace aoscore {
namespace {

using testing::natural_pair;
using testing::Pair;

/// Blocks of one pixel each with these squared errors.
BlockErrors blocks_of(const std::vector<double>& squared_errors) {
    BlockErrors blocks;
    blocks.side_px = 1;
    blocks.across = static_cast<int>(squared_errors.size());
    blocks.down = 1;
    blocks.counts.assign(squared_errors.size(), 1);
    blocks.squared_sums = squared_errors;
    for (const double squared : squared_errors) {
        blocks.absolute_sums.push_back(std::sqrt(squared));
        blocks.signed_sums.push_back(std::sqrt(squared));
    }
    return blocks;
}

std::vector<double> values(const std::string& metric, const BlockErrors& blocks, std::uint64_t seed = 1) {
    const std::array<const BlockErrors*, 1> images{&blocks};
    return resampled(metric, images, seed);
}

TEST(BlockErrors, AddUpToTheImage) {
    Pair pair = natural_pair(130, 70);
    testing::mask_out(pair, 0.7);
    const ImageF standard_error(130, 70, 0.5F);
    const BlockErrors blocks = block_errors(pair.input(&standard_error));
    EXPECT_EQ(blocks.side_px, 5);
    ASSERT_EQ(blocks.counts.size(), static_cast<std::size_t>(blocks.across * blocks.down));
    double count = 0, squared = 0, variance = 0;
    for (std::size_t i = 0; i < blocks.counts.size(); ++i) {
        count += blocks.counts[i];
        squared += blocks.squared_sums[i];
        variance += blocks.variance_sums[i];
    }
    EXPECT_EQ(count, std::count(pair.valid.pixels.begin(), pair.valid.pixels.end(), 1));
    EXPECT_NEAR(std::sqrt(squared / count), *metrics().front().measure(pair.input()).value, 1e-12);
    EXPECT_DOUBLE_EQ(variance, 0.25 * count);
}

TEST(Bootstrap, IntervalHoldsTheTrueValueAboutAsOftenAsItSays) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    int held = 0;
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        std::vector<double> squared;
        for (int i = 0; i < 120; ++i) squared.push_back(std::pow(normal(random), 2));
        const auto interval = confidence_interval(values("rmse", blocks_of(squared), trial));
        ASSERT_TRUE(interval);
        held += interval->low <= 1 && 1 <= interval->high;
    }
    // 95 % of 200 is 190 with a standard deviation of 3.1; a percentile interval of 120 heavy-tailed values
    // holds a little less.
    EXPECT_GE(held, 175);
    EXPECT_LT(held, 200);
}

TEST(Bootstrap, DifferencesArePairedSoThatWhatTwoTestsShareCancels) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    int held = 0;
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        std::vector<double> a, b;
        for (int i = 0; i < 120; ++i) {
            const double common = 10 * std::abs(normal(random));
            a.push_back(common + 1 + 0.2 * normal(random));
            b.push_back(common + 1.2 + 0.2 * normal(random));
            a.back() = std::pow(a.back(), 2);
            b.back() = std::pow(b.back(), 2);
        }
        const auto of_a = values("mae", blocks_of(a), trial), of_b = values("mae", blocks_of(b), trial);
        const auto paired = confidence_interval(of_a, of_b), alone = confidence_interval(of_a);
        ASSERT_TRUE(paired && alone);
        EXPECT_LT(paired->high - paired->low, 0.1 * (alone->high - alone->low));
        held += paired->low <= -0.2 && -0.2 <= paired->high;
    }
    EXPECT_GE(held, 177);
    EXPECT_LE(held, 200);
}

TEST(Bootstrap, IntervalsHoldTheirMetricsAndAreNarrowForLargeImages) {
    const Pair pair = natural_pair(240, 240);
    const ImageF standard_error(240, 240, 0.01F);
    const MetricInput input = pair.input(&standard_error);
    const BlockErrors blocks = block_errors(input);
    const std::array<const BlockErrors*, 1> images{&blocks};
    const auto intervals = confidence_intervals(images, 1);
    EXPECT_EQ(intervals.size(), 5U);
    for (const Metric& metric : metrics()) {
        const auto found = intervals.find(std::string(metric.id));
        if (found == intervals.end()) continue;
        const double value = *metric.measure(input).value;
        EXPECT_LT(found->second.low, value) << metric.id;
        EXPECT_GT(found->second.high, value) << metric.id;
        EXPECT_LT(found->second.high - found->second.low, 0.2 * std::abs(value)) << metric.id;
    }
}

TEST(Bootstrap, OfSeveralViewsIsWiderThanOfEachBecauseViewsDiffer) {
    const BlockErrors low = blocks_of(std::vector<double>(100, 0.01)),
                      high = blocks_of(std::vector<double>(100, 0.09));
    const std::array<const BlockErrors*, 4> images{&low, &high, &low, &high};
    const auto interval = confidence_interval(resampled("rmse", images, 3));
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, 0.1, 0.06);
    EXPECT_NEAR(interval->high, 0.3, 0.06);
    EXPECT_GT(interval->high - interval->low, 0.1);
    EXPECT_NEAR(confidence_interval(values("rmse", low))->high, 0.1, 1e-12);
}

TEST(Bootstrap, HasNoIntervalWithoutAValidPixelNorForAnInfinitePsnr) {
    Pair pair = natural_pair(48, 48);
    pair.valid = Mask(48, 48, 0);
    const BlockErrors nothing = block_errors(pair.input());
    const std::array<const BlockErrors*, 1> images{&nothing};
    EXPECT_TRUE(confidence_intervals(images, 1).empty());
    EXPECT_FALSE(confidence_interval(values("psnr", blocks_of({0, 0, 0}))));
    EXPECT_THROW(values("ssim", nothing), Error);
}

}  // namespace
}  // namespace aoscore
