#include "metrics/intervals/over_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace aoscore {
namespace {

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The variance with the number of values as its divisor.
double variance(const std::vector<double>& values) {
    const double centre = mean(values);
    double sum = 0;
    for (const double value : values) sum += (value - centre) * (value - centre);
    return sum / static_cast<double>(values.size());
}

std::vector<double> squares(std::vector<double> values) {
    for (double& value : values) value *= value;
    return values;
}

TEST(OverScenes, CountsScenesAlikeWhateverTheirNumberOfViews) {
    EXPECT_DOUBLE_EQ(error_over_scenes({{0.3}}), 0.3);
    EXPECT_DOUBLE_EQ(error_over_scenes({{0.1, 0.1, 0.1, 0.1}, {0.7}}), 0.5);  // sqrt((.01 + .49) / 2)
    EXPECT_DOUBLE_EQ(error_over_scenes({{3, 5}, {4}}), std::sqrt((17 + 16) / 2.0));
}

TEST(OverScenes, DrawsNothingWhereThereIsOneViewOfOneScene) {
    for (const double draw : over_scenes({{0.25}}, 1).draws) EXPECT_DOUBLE_EQ(draw, 0.25);
}

// Given the errors, a drawn mean square is the mean over S independent scenes of the mean over V drawn views,
// whose variance is (variance of the scenes' means + mean over scenes of the views' variance / V) / S.
TEST(OverScenes, HasTheVarianceThatDrawingScenesAndThenViewsHas) {
    const ErrorsByScene errors = {{0.1, 0.2, 0.15}, {0.3, 0.1, 0.2}, {0.05, 0.4, 0.1}, {0.2, 0.2, 0.25}};
    std::vector<double> means, within;
    for (const std::vector<double>& views : errors) {
        means.push_back(mean(squares(views)));
        within.push_back(variance(squares(views)) / 3);
    }
    const double expected = (variance(means) + mean(within)) / 4;
    std::vector<double> drawn_variances, drawn_means;
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
        const std::vector<double> draws = squares(over_scenes(errors, seed).draws);
        drawn_means.push_back(mean(draws));
        drawn_variances.push_back(variance(draws));
    }
    // Of 50,000 draws the variance is known to within about 1 %.
    EXPECT_NEAR(mean(drawn_variances), expected, 0.03 * expected);
    EXPECT_NEAR(mean(drawn_means), mean(means), 4 * std::sqrt(expected / 50000));
}

TEST(OverScenes, IsPairedOverContestantsOnTheSameViews) {
    const ErrorsByScene a = {{0.1, 0.2}, {0.3, 0.1, 0.5}, {0.4}};
    ErrorsByScene doubled = a;
    for (std::vector<double>& views : doubled) {
        for (double& error : views) error *= 2;
    }
    const Resampled one = over_scenes(a, 7), two = over_scenes(doubled, 7);
    ASSERT_EQ(one.draws.size(), two.draws.size());
    for (std::size_t i = 0; i < one.draws.size(); ++i) EXPECT_DOUBLE_EQ(two.draws[i], 2 * one.draws[i]);
}

// Made-up studies of 25 scenes with 3 views: mean squares with an effect of the scene and one of the view,
// whose expectation is known. The interval holds it about as often as it says.
TEST(OverScenes, HoldsTheExpectationOverAllScenesAsOftenAsItSays) {
    std::mt19937_64 random(11);
    std::gamma_distribution<double> of_scene(4.0, 0.0025), of_view(8.0, 1.0 / 8);  // means .01 and 1
    constexpr int kStudies = 300;
    int held = 0;
    for (int study = 0; study < kStudies; ++study) {
        ErrorsByScene errors(25);
        for (std::vector<double>& views : errors) {
            const double scene = of_scene(random);
            for (int view = 0; view < 3; ++view) views.push_back(std::sqrt(scene * of_view(random)));
        }
        const auto interval = confidence_interval(over_scenes(errors, 3).draws);
        ASSERT_TRUE(interval);
        held += interval->low <= 0.1 && 0.1 <= interval->high ? 1 : 0;
    }
    EXPECT_GE(held, 0.90 * kStudies);
    EXPECT_LE(held, 0.985 * kStudies);
}

}  // namespace
}  // namespace aoscore
