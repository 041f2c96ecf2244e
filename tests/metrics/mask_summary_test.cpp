// Compares areas of missing and false occlusion against noisy truths with those that closed forms give for
// the distribution of the errors, where the plain share of the pixels beyond the threshold is too large.
#include "metrics/analysis/mask_summary.h"

#include "metrics/analysis/error_distribution.h"
#include "metrics/analysis/mask_totals.h"
#include "metrics/analysis/occlusion_masks.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/intervals/bootstrap.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace aoscore {
namespace {

using testing::Pair;

constexpr double kThreshold = 0.1;

/// A picture whose errors (test - truth) are the quantiles of a distribution, in the order of the pixels,
/// with normal noise in the truth.
struct NoisyPicture {
    Pair pair;
    ImageF standard_error;

    NoisyPicture(int side_px, double noise, const std::function<double(double)>& quantile, unsigned seed)
        : pair(side_px, side_px), standard_error(side_px, side_px, static_cast<float>(noise)) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal(0, noise);
        for (std::size_t i = 0; i < pair.truth.size(); ++i) {
            const double rank = (static_cast<double>(i) + 0.5) / static_cast<double>(pair.truth.size());
            pair.test.pixels[i] = 0.5F;
            pair.truth.pixels[i] = static_cast<float>(0.5 - quantile(rank) + normal(random));
        }
    }
    MetricInput input() const { return pair.input(&standard_error); }
    double plain_area() const {
        return measure_mask(pair.input(), MaskSide::missing, kThreshold).summary.area;
    }
    MeasuredMask missing() const { return measure_mask(input(), MaskSide::missing, kThreshold); }
};

/// Errors of an exponential density with a mean of .05: exp(-2) of them exceed .1, and their mean is .15.
double exponential(double rank) {
    return -0.05 * std::log(1 - rank);
}

/// sinh(x) / x: what spreading over a box of half the width x does to an exponential of scale 1.
double sinhc(double x) {
    return std::sinh(x) / x;
}

// Noise of the standard deviation s multiplies the plain area by exp(200 s^2), which is 1.083 at .02. Boxes
// of half the widths s sqrt(3/4) and s sqrt(6), whose variances are s^2/4 and 2 s^2, multiply that by sinhc,
// and 12/7 and -5/7 of them leave 0.99.
TEST(MaskArea, OfExponentialErrorsIsTheClosedFormThatNoiseRaises) {
    constexpr double kNoise = 0.02, kArea = 0.1353352832366127;
    const double raised = std::exp(200 * kNoise * kNoise);
    const double left =
        raised * (12 * sinhc(20 * kNoise * std::sqrt(0.75)) - 5 * sinhc(20 * kNoise * std::sqrt(6.0))) / 7;
    EXPECT_NEAR(left, 0.99, 0.002);
    double plain = 0, area = 0, mean = 0;
    constexpr int kSeeds = 20;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const NoisyPicture picture(200, kNoise, exponential, seed);
        plain += picture.plain_area() / kSeeds;
        area += picture.missing().summary.area / kSeeds;
        mean += *picture.missing().summary.mean / kSeeds;
        EXPECT_NEAR(picture.missing().summary.area, kArea, *picture.missing().truth_noise);
    }
    EXPECT_NEAR(plain, raised * kArea, 0.0005);
    EXPECT_NEAR(area, left * kArea, 0.0005);
    EXPECT_NEAR(mean, 0.15, 0.001);
}

// Where errors about the threshold are equally frequent, nothing is left.
TEST(MaskArea, OfEvenlySpreadErrorsIsExact) {
    double area = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
        area += NoisyPicture(
                    200, 0.03, [](double rank) { return 0.4 * rank - 0.1; }, seed)
                    .missing()
                    .summary.area /
                20;
    EXPECT_NEAR(area, 0.5, 0.0005);
}

TEST(MaskArea, WithoutNoiseIsTheShareOfThePixels) {
    Pair pair = testing::natural_pair(90, 60);
    testing::mask_out(pair, 0.8);
    const ImageF sure(90, 60, 0.0F);
    const OcclusionMasks masks = occlusion_masks(pair.input());
    const auto count = [](const Mask& mask) {
        return static_cast<double>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
    };
    for (const ImageF* standard_error : {static_cast<const ImageF*>(nullptr), &sure}) {
        const MetricInput input = pair.input(standard_error);
        EXPECT_GT(count(masks.missing), 100);
        EXPECT_NEAR(measure_mask(input, MaskSide::missing, kThreshold).summary.area,
                    count(masks.missing) / count(pair.valid), 1e-12);
        EXPECT_NEAR(measure_mask(input, MaskSide::false_occlusion, kThreshold).summary.area,
                    count(masks.false_occlusion) / count(pair.valid), 1e-12);
    }
    EXPECT_EQ(measure_mask(pair.input(&sure), MaskSide::missing, kThreshold).truth_noise, 0);
    EXPECT_FALSE(measure_mask(pair.input(), MaskSide::missing, kThreshold).truth_noise);
}

TEST(MaskArea, IsNothingWhereNoTruthCouldBeSoFarAway) {
    Pair pair(50, 50);
    const ImageF noise(50, 50, 0.2F);
    std::ranges::fill(pair.truth.pixels, 0.9F);
    std::ranges::fill(pair.test.pixels, 0.95F);
    EXPECT_EQ(measure_mask(pair.input(&noise), MaskSide::false_occlusion, kThreshold).summary.area, 0);
    EXPECT_GT(measure_mask(pair.input(&noise), MaskSide::missing, kThreshold).summary.area, 0);
}

TEST(MaskArea, OfBlocksIsThatOfThePicture) {
    const NoisyPicture picture(120, 0.05, exponential, 3);
    EXPECT_NEAR(value_of_blocks(kMissingArea, with_masks(block_errors(picture.input()),
                                                         mask_totals(picture.input(), kThreshold))),
                picture.missing().summary.area, 1e-12);
}

TEST(MaskArea, CausesAddUpToItAndNoneIsNegative) {
    NoisyPicture picture(60, 0.08, exponential, 5);
    ImageF left(60, 60, 0.0F), right(60, 60, 0.0F), rare(60, 60, 0.0F);
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x) (x < 20 ? left : x < 55 ? right : rare).at(x, y) = 0.4F;
    }
    const MaskSummary summary = measure_mask(picture.input(), MaskSide::missing, kThreshold,
                                             {{"left", &left}, {"right", &right}, {"rare", &rare}})
                                    .summary;
    double sum = 0;
    for (const CauseShare& cause : summary.causes) {
        EXPECT_GE(cause.area, 0) << cause.cause;
        EXPECT_GE(cause.mean.value_or(kThreshold), kThreshold);
        sum += cause.area;
    }
    EXPECT_NEAR(sum, summary.area, 1e-12);
}

// The integrals that its comment names, by the midpoint rule.
TEST(MaskArea, VarianceOfDoubtIsThatOfNormalNoise) {
    double of_share = 0, of_doubt = 0;
    for (double x = -12; x < 12; x += 0.01) {
        double weight = 0, share = 0, squares = 0, doubt = 0;
        for (double z = -6; z < 6; z += 0.02) {
            const double density = std::exp(-z * z / 2);
            const BeyondThreshold beyond = beyond_threshold(x + z, 1, 0, 1e9);
            weight += density;
            share += density * beyond.share;
            squares += density * beyond.share * beyond.share;
            doubt += density * beyond.doubt;
        }
        of_share += squares / weight - share * share / (weight * weight);
        of_doubt += doubt / weight;
    }
    EXPECT_NEAR(kVarianceOfDoubt, of_share / of_doubt, 0.001);
}

TEST(MaskArea, HasTheVarianceThatItsDoubtSays) {
    constexpr int kSeeds = 200, kSide = 60;
    std::vector<double> areas;
    double doubt = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
        const NoisyPicture picture(
            kSide, 0.03, [](double rank) { return 0.4 * rank - 0.1; }, seed);
        areas.push_back(picture.missing().summary.area);
        for (std::size_t i = 0; i < picture.pair.truth.size(); ++i)
            doubt += beyond_threshold(picture.input(), i, MaskSide::missing, kThreshold).doubt;
    }
    doubt /= kSeeds * kSide * kSide;
    const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / kSeeds;
    double variance = 0;
    for (const double area : areas) variance += (area - mean) * (area - mean) / (kSeeds - 1);
    EXPECT_NEAR(variance / (kVarianceOfDoubt * doubt / (kSide * kSide)), 1, 0.25);
}

/// The largest distance of a curve from the areas beyond each of its steps, of which it is let rise alone.
double farthest_from_areas(const MetricInput& input) {
    const ErrorDistribution curve = error_distribution(input);
    const auto total = [](const std::vector<double>& sums) {
        return std::accumulate(sums.begin(), sums.end(), 0.0);
    };
    double farthest = 0, within = 0;
    for (std::size_t i = 0; i < curve.cumulative.size(); ++i) {
        const BlockErrors blocks = with_masks(
            block_errors(input), mask_totals(input, static_cast<double>(i) * curve.cumulative_step));
        const double beyond =
            (total(blocks.missing_counts) + total(blocks.false_counts)) / total(blocks.counts);
        within = std::max(within, std::min(1 - beyond, 1.0));
        farthest = std::max(farthest, std::abs(within - curve.cumulative[i]));
    }
    return farthest;
}

// So percentiles of |error| that are read from the curve are as free of noise as the areas are.
TEST(ErrorCurve, IsOneLessTheAreasBeyondItsSteps) {
    const NoisyPicture picture(80, 0.02, exponential, 2);
    EXPECT_LT(farthest_from_areas(picture.input()), 1e-9);
    EXPECT_LT(farthest_from_areas(picture.pair.input()), 1e-9);
    Pair bright(64, 48);
    const ImageF noise(64, 48, 0.03F);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0.8F, 1);
    for (std::size_t i = 0; i < bright.truth.size(); ++i) {
        bright.truth.pixels[i] = value(random);
        bright.test.pixels[i] = value(random);
    }
    EXPECT_LT(farthest_from_areas(bright.input(&noise)), 1e-9) << "where no truth could be beyond";
}

// 95 % of these errors are below .05 ln 20. The curve is known at steps of .005.
TEST(ErrorCurve, HasThePercentilesOfTheErrorsWithoutNoise) {
    const auto percentile = [](const ErrorDistribution& curve, double share) {
        const auto found = std::ranges::lower_bound(curve.cumulative, share);
        return curve.cumulative_step * static_cast<double>(found - curve.cumulative.begin());
    };
    const NoisyPicture picture(400, 0.025, exponential, 4);
    const ErrorDistribution debiased = error_distribution(picture.input()),
                            plain = error_distribution(picture.pair.input());
    for (const double share : {0.9, 0.95, 0.99}) {
        const double exact = exponential(share);
        EXPECT_NEAR(percentile(debiased, share), exact, 0.0051) << share;
        EXPECT_GT(percentile(plain, share), exact + 0.0051) << share;
    }
}

}  // namespace
}  // namespace aoscore
