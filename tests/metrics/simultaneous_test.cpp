// Tests invented scores whose ranks are known.
#include "metrics/intervals/simultaneous.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace aoscore {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Measures of these values whose draws err independently, by a normal error of this deviation.
std::vector<Resampled> scattered(const std::vector<double>& values, double deviation, int draws,
                                 std::mt19937_64& random) {
    std::normal_distribution<double> error(0, deviation);
    std::vector<Resampled> measures;
    for (const double value : values) {
        measures.push_back({value, {}});
        for (int i = 0; i < draws; ++i) measures.back().draws.push_back(value + error(random));
    }
    return measures;
}

std::vector<RankRange> ranges(const std::vector<Resampled>& measures) {
    const Ranks ranks(measures);
    std::vector<RankRange> all;
    for (std::size_t i = 0; i < measures.size(); ++i) all.push_back(ranks.range(i));
    return all;
}

// The studentised range of infinitely many degrees of freedom, 5 % (Leon Harter, Tables of Range and
// Studentized Range, 1960): k independent means of one variance differ by no more than that.
TEST(SimultaneousIntervals, OfIndependentMeansAreThoseOfTukey) {
    const std::map<int, double> published{{2, 2.772}, {3, 3.314}, {5, 3.858}, {10, 4.474}, {20, 5.012}};
    for (const auto& [count, range] : published) {
        std::mt19937_64 random(static_cast<unsigned>(count));
        const auto measures =
            scattered(std::vector<double>(static_cast<std::size_t>(count), 1.0), 0.1, 20000, random);
        const Interval difference = *Ranks(measures).difference(0, 1);
        EXPECT_NEAR((difference.high - difference.low) / 2, 0.1 * range, 0.03 * 0.1 * range) << count;
    }
}

TEST(SimultaneousIntervals, FailTogetherInOneCaseOfTwenty) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> error(0, 1);
    int failed = 0, missed_ranks = 0;
    constexpr int kTrials = 500;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> equal(5), apart(5);
        for (std::size_t i = 0; i < 5; ++i) {
            equal[i] = error(random);
            apart[i] = 2.0 * static_cast<double>(i) + error(random);
        }
        const Ranks of_equal(scattered(equal, 1, 400, random));
        for (std::size_t i = 0; i < 5; ++i) {
            if (of_equal.range(i) == RankRange{1, 5}) continue;
            ++failed;
            break;
        }
        const auto of_apart = ranges(scattered(apart, 1, 400, random));
        for (int i = 0; i < 5; ++i) {
            const RankRange& range = of_apart[static_cast<std::size_t>(i)];
            if (range.best <= i + 1 && i + 1 <= range.worst) continue;
            ++missed_ranks;
            break;
        }
    }
    // The expected number is 25 of 500, with a standard deviation of 5.
    EXPECT_GE(failed, 10);
    EXPECT_LE(failed, 40);
    EXPECT_LE(missed_ranks, 40) << "fewer, for surely different ones cannot be confused";
}

TEST(Ranks, SayWhatIsNotTransitive) {
    std::mt19937_64 random(3);
    // Neighbours are 1.57 standard deviations of their difference apart, the outer two 3.14; 2.34 are needed.
    const auto measures = scattered({0, 1, 2}, 0.45, 4000, random);
    EXPECT_EQ(ranges(measures), (std::vector<RankRange>{{1, 2}, {1, 3}, {2, 3}}));
    const Ranks ranks(measures);
    EXPECT_EQ(ranks.ties(0), std::vector<std::size_t>{1});
    EXPECT_EQ(ranks.ties(1), (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(ranks.ties(2), std::vector<std::size_t>{1});
}

TEST(Ranks, DoNotDependOnTheOrderInWhichMeasuresAreGiven) {
    std::mt19937_64 random(3);
    std::vector<Resampled> measures = scattered({5, 1, 2, 0, 1.2}, 0.45, 2000, random);
    std::vector<RankRange> forward = ranges(measures);
    std::ranges::reverse(measures);
    std::ranges::reverse(forward);
    EXPECT_EQ(ranges(measures), forward);
}

TEST(Ranks, OfOneAreOneAndOfEqualOnesAreAll) {
    EXPECT_TRUE(ranges({}).empty());
    std::mt19937_64 random(1);
    EXPECT_EQ(ranges(scattered({0.2}, 0.1, 100, random)), (std::vector<RankRange>{{1, 1}}));
    const Resampled one = scattered({0.2}, 0.1, 100, random)[0];
    EXPECT_EQ(ranges({one, one, one}), std::vector<RankRange>(3, {1, 3}));
    const Resampled constant{0.3, std::vector<double>(100, 0.3)};
    EXPECT_EQ(ranges({constant, constant}), std::vector<RankRange>(2, {1, 2}));
}

TEST(Ranks, TakeADifferenceThatNoDrawChangesAsExactAndLetItWidenNoOther) {
    std::mt19937_64 random(1);
    std::vector<Resampled> measures = scattered({0.2, 0.2}, 0.1, 2000, random);
    const Interval before = *Ranks(measures).difference(0, 1);
    measures.push_back(measures[0]);
    measures[2].value += 1e-6;
    for (double& draw : measures[2].draws) draw += 1e-6;
    const Ranks ranks(measures);
    EXPECT_TRUE(ranks.surely_lower(0, 2));
    EXPECT_EQ(ranks.range(0), (RankRange{1, 2}));
    EXPECT_EQ(ranks.range(2), (RankRange{2, 3}));
    EXPECT_NEAR(ranks.difference(0, 1)->high, before.high, 1e-6);
}

TEST(Ranks, PassOverDrawsThatAreNoNumbersAndTellNothingApartWithoutAny) {
    std::mt19937_64 random(1);
    std::vector<Resampled> measures = scattered({0, 10}, 1, 200, random);
    for (std::size_t i = 0; i < 20; ++i) measures[0].draws[i] = kNaN;
    measures[1].draws[50] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(ranges(measures), (std::vector<RankRange>{{1, 1}, {2, 2}}));
    measures.push_back({5, std::vector<double>(200, kNaN)});
    EXPECT_EQ(ranges(measures), (std::vector<RankRange>{{1, 2}, {2, 3}, {1, 3}}));
    EXPECT_FALSE(Ranks(measures).difference(0, 2));
    EXPECT_EQ(Ranks(measures).ties(2), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(ranges({{1, {}}, {2, {}}}), std::vector<RankRange>(2, {1, 2}));
    measures[0].draws.pop_back();
    EXPECT_THROW(Ranks{measures}, Error);
}

}  // namespace
}  // namespace aoscore
