#include "core/sampling.h"
#include "reference/estimate/estimate.h"
#include "reference/estimate/variance_fall.h"
#include "reference/sampling/point_sets.h"
#include "reference/test_scenes.h"
#include "reference/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace aoscore {
namespace {

const CameraFrame kFrame(testing::looking({2, 2, 3}, {0, 0.5, 0}), 80, 60);

/// Many runs of one picture with different seeds: the true and the stated error of each pixel.
struct Runs {
    std::vector<double> mean, true_variance, stated_variance;  // values of pixels with a surface
    double rmse() const {
        double sum = 0;
        for (const double v : true_variance) sum += v;
        return std::sqrt(sum / static_cast<double>(true_variance.size()));
    }
};

Runs run(const ReferenceScene& scene, const TruthQuery& query, TruthSettings settings, int seeds) {
    std::vector<Truth> truths;
    for (int s = 0; s < seeds; ++s) {
        settings.seed = static_cast<std::uint64_t>(s) + 1;
        truths.push_back(scene.trace(kFrame, {query}, settings, "calibration"));
    }
    Runs runs;
    for (std::size_t i = 0; i < truths[0].hits.surface.size(); ++i) {
        if (truths[0].hits.surface.pixels[i] == 0) continue;
        double mean = 0, variance = 0, stated = 0;
        for (const Truth& t : truths) {
            mean += t.visibility[0].pixels[i] / seeds;
            stated += std::pow(t.standard_error[0].pixels[i], 2) / seeds;
        }
        for (const Truth& t : truths) variance += std::pow(t.visibility[0].pixels[i] - mean, 2) / (seeds - 1);
        runs.mean.push_back(mean);
        runs.true_variance.push_back(variance);
        runs.stated_variance.push_back(stated);
    }
    return runs;
}

/// Compares errors in bins of visibility, without pixels that are open or blocked but for two rays, whose
/// rays are all alike in many runs. Errors are shrunk towards the mean of their tile, so that those of one
/// bin may be stated a fifth too large, but hardly too small.
void expect_calibrated(const Runs& runs, int samples) {
    constexpr std::array kBins = {0.0, 0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 1.0};
    const double lowest = 2.0 / samples, highest = 1 - lowest;
    int filled = 0;
    for (std::size_t b = 0; b + 1 < kBins.size(); ++b) {
        double true_sum = 0, stated_sum = 0;
        int pixels = 0;
        for (std::size_t i = 0; i < runs.mean.size(); ++i) {
            if (runs.mean[i] < std::max(lowest, kBins[b]) || runs.mean[i] >= std::min(highest, kBins[b + 1]))
                continue;
            ++pixels;
            true_sum += runs.true_variance[i];
            stated_sum += runs.stated_variance[i];
        }
        if (pixels < 60) continue;
        ++filled;
        const double ratio = std::sqrt(true_sum / stated_sum);
        EXPECT_GT(ratio, 0.78) << "V from " << kBins[b] << " to " << kBins[b + 1] << ", " << pixels
                               << " pixels";
        EXPECT_LT(ratio, 1.1) << "V from " << kBins[b] << " to " << kBins[b + 1] << ", " << pixels
                              << " pixels";
    }
    EXPECT_GE(filled, 5);
}

TEST(StandardErrors, AreCalibratedOnSmoothAndOnSharpShadows) {
    const ReferenceScene scene(testing::still_life());
    TruthSettings settings;
    for (const int samples : {48, 128, 512}) {
        SCOPED_TRACE(samples);
        settings.samples = samples;
        expect_calibrated(run(scene, {Falloff::binary, INFINITY, 0}, settings, 40), settings.samples);
    }
}

TEST(StandardErrors, AreCalibratedAmongThinOccluders) {
    const ReferenceScene scene(testing::thicket());
    TruthSettings settings;
    settings.samples = 128;
    expect_calibrated(run(scene, {Falloff::binary, INFINITY, 0}, settings, 40), settings.samples);
    expect_calibrated(run(scene, {Falloff::quadratic, 1.5, 0}, settings, 40), settings.samples);
}

TEST(StandardErrors, AreHonestWhereAllRaysOfAPixelAgree) {
    // Pixels are chosen by the rays seen, not by their visibility: all rays were open, or all were blocked.
    for (const Scene& scene : {testing::still_life(), testing::thicket()}) {
        const ReferenceScene reference(scene);
        TruthSettings settings;
        settings.samples = 8192;
        settings.skip_open = false;
        const std::vector<TruthQuery> query = {{Falloff::binary, INFINITY, 0}};
        const Truth exact = reference.trace(kFrame, query, settings, "exact");
        for (const int samples : {32, 64, 128}) {
            settings.samples = samples;
            double squared = 0, stated = 0;
            int pixels = 0, beyond = 0;
            for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                settings.seed = seed;
                const Truth truth = reference.trace(kFrame, query, settings, "agreeing");
                for (std::size_t i = 0; i < truth.visibility[0].size(); ++i) {
                    const float v = truth.visibility[0].pixels[i];
                    if (truth.hits.surface.pixels[i] == 0 || (v != 0 && v != 1)) continue;
                    const double error = std::abs(v - exact.visibility[0].pixels[i]);
                    squared += error * error;
                    stated += std::pow(truth.standard_error[0].pixels[i], 2);
                    beyond += error > 3 * truth.standard_error[0].pixels[i];
                    ++pixels;
                }
            }
            settings.seed = 1;
            ASSERT_GT(pixels, 500);
            const double ratio = std::sqrt(squared / stated);
            EXPECT_LT(ratio, 1.4) << samples << " samples, " << pixels << " pixels";
            EXPECT_GT(ratio, 0.4) << samples << " samples, " << pixels << " pixels";
            EXPECT_LT(beyond, 0.02 * pixels) << samples << " samples, " << pixels << " pixels";
        }
    }
}

TEST(StandardErrors, OfAWholePictureAreIndependentBetweenNeighbours) {
    // The error of a mean over pixels is that of independent pixels, since they share no samples.
    const ReferenceScene scene(testing::thicket());
    TruthSettings settings;
    settings.samples = 64;
    constexpr int kSeeds = 100;
    double sum = 0, squares = 0, variance = 0;
    for (int s = 0; s < kSeeds; ++s) {
        settings.seed = static_cast<std::uint64_t>(s) + 1000;
        const Truth truth = scene.trace(kFrame, {{Falloff::binary, 1, 0}}, settings, "independence");
        double picture = 0;
        for (std::size_t i = 0; i < truth.visibility[0].size(); ++i) {
            picture += truth.visibility[0].pixels[i];
            variance += std::pow(truth.standard_error[0].pixels[i], 2) / kSeeds;
        }
        sum += picture;
        squares += picture * picture;
    }
    const double seen = (squares - sum * sum / kSeeds) / (kSeeds - 1);
    // The variance of 100 values is known to 14 %; the limit is four times that.
    EXPECT_LT(seen / variance, 1.6);
    EXPECT_GT(seen / variance, 0.4);
}

/// Slope of log error over log samples, by least squares.
double slope(const ReferenceScene& scene, PointKind kind) {
    double x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    int n = 0;
    for (int samples = 16; samples <= 1024; samples *= 4, ++n) {
        TruthSettings settings;
        settings.samples = samples;
        settings.points = kind;
        const double x = std::log(samples),
                     y = std::log(run(scene, {Falloff::binary, 1, 0}, settings, 6).rmse());
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return (xy - x_sum * y_sum / n) / (xx - x_sum * x_sum / n);
}

TEST(StandardErrors, FallFasterThanMonteCarlo) {
    const ReferenceScene scene(testing::still_life());
    EXPECT_LT(slope(scene, PointKind::scrambled_sobol), -0.7);
    EXPECT_NEAR(slope(scene, PointKind::independent), -0.5, 0.03);
}

TEST(Estimates, CompareBlocksWithTheirSiblings) {
    // 7 rays make blocks of one, of which the seventh has no sibling.
    const std::array sums = {1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0};
    const PixelSpread pixel = pixel_spread(sums, 7);
    EXPECT_DOUBLE_EQ(pixel.visibility, 3.0 / 7);
    EXPECT_EQ(pixel.pairs, (std::array{3, 1, 0}));
    EXPECT_DOUBLE_EQ(pixel.differences[0], (0.25 + 0 + 0) / 3);
    EXPECT_DOUBLE_EQ(pixel.differences[1], 0.25 * 0.25);
}

TEST(Estimates, PoolAlignedBlocksByTheFallOfEachStep) {
    const double once = variance_fall(0.37, 64), twice = once * variance_fall(0.37, 128);
    const double thrice = twice * variance_fall(0.37, 256);
    EXPECT_NEAR(pooled_variance(512, 0.37), thrice, 1e-12);
    // For three of four, V(3 n) = (V(n) + 8 V(4 n)) / 9, here of pairs of blocks.
    EXPECT_NEAR(pooled_variance(384, 0.37), (once + 8 * thrice) / 9, 1e-12);
    // For five of eight, by 25 V(5 n) = 16 V(4 n) + V(n) + 8 cov, where 2 cov = 2 (2 V(8 n) - V(4 n)).
    EXPECT_NEAR(pooled_variance(320, 0.37), (16 * twice + 1 + 8 * (2 * thrice - twice)) / 25, 1e-12);
}

/// Of half planes that cut the unit square at random, the mean squared error of their area by the first
/// 2^step of the points, for steps from 0.
std::vector<double> variances_of_half_planes(int steps) {
    const PointSets sets(PointKind::scrambled_sobol, 1 << (steps - 1));
    constexpr int kPlanes = 40000;
    std::vector<double> variances(static_cast<std::size_t>(steps));
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < kPlanes; ++k) {
        const double angle = 2 * std::numbers::pi * unit(random);
        const double nx = std::cos(angle), ny = std::sin(angle);
        const double offset = nx * unit(random) + ny * unit(random);
        // The square, clipped at the line: its area by the shoelace formula.
        constexpr std::array<std::array<double, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        std::vector<std::array<double, 2>> polygon;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& a = kCorners[i];
            const auto& b = kCorners[(i + 1) % 4];
            const double da = nx * a[0] + ny * a[1] - offset, db = nx * b[0] + ny * b[1] - offset;
            if (da > 0) polygon.push_back(a);
            if ((da > 0) != (db > 0))
                polygon.push_back(
                    {std::lerp(a[0], b[0], da / (da - db)), std::lerp(a[1], b[1], da / (da - db))});
        }
        double area = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const auto& a = polygon[i];
            const auto& b = polygon[(i + 1) % polygon.size()];
            area += (a[0] * b[1] - b[0] * a[1]) / 2;
        }
        const PointSets::Coordinates points = sets.set(random());
        const std::uint64_t shift = random();
        double inside = 0;
        std::size_t step = 0;
        for (std::uint32_t i = 0; i < 1u << (steps - 1); ++i) {
            const double u = (points.u[i] ^ static_cast<std::uint32_t>(shift)) * 0x1p-32;
            const double v = (points.v[i] ^ static_cast<std::uint32_t>(shift >> 32)) * 0x1p-32;
            inside += nx * u + ny * v > offset;
            if (!std::has_single_bit(i + 1)) continue;
            variances[step++] += std::pow(inside / (i + 1) - area, 2) / kPlanes;
        }
    }
    return variances;
}

// The falls were measured on scenes; edges in the square of the points show the same of these sets.
TEST(Estimates, FallFromStepToStepAsTheSetsOfPointsDo) {
    const std::vector<double> variances = variances_of_half_planes(9);
    for (std::size_t step = 3; step + 1 < variances.size(); ++step) {
        const double fall = variances[step + 1] / variances[step];
        EXPECT_NEAR(fall / variance_fall(std::exp2(-1.5), 1 << step), 1, 0.05) << "from " << (1 << step);
    }
    EXPECT_GT(variances[5] / variances[4],
              1.02 * std::sqrt(variances[4] / variances[3] * variances[6] / variances[5]));
}

TEST(Estimates, OfALoneNoisyPixelLeanOnTheUsualLaw) {
    const std::array sums = {5.0, 9.0, 2.0, 7.0, 8.0, 4.0, 4.0, 3.0};
    const PixelSpread pixel = pixel_spread(sums, 128);
    const double error = moderated_estimates({&pixel, 1}, {})[0].standard_error;
    double spread = 0;  // as if blocks were independent
    for (const double sum : sums) spread += std::pow(sum / 16 - (1 - pixel.visibility), 2) / (7 * 8);
    EXPECT_LT(error, std::sqrt(spread));
    EXPECT_GT(error, 0.3 * std::sqrt(spread));
}

TEST(Estimates, NeverStateNothing) {
    const std::array none = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const std::array all = {32.0, 32.0, 32.0, 32.0, 32.0, 32.0, 32.0, 32.0};
    const std::array half = {16.0, 16.0, 16.0, 16.0, 16.0, 16.0, 16.0, 16.0};
    for (const auto& sums : {none, all, half}) {
        const PixelSpread pixel = pixel_spread(sums, 256);
        const double error = moderated_estimates({&pixel, 1}, {})[0].standard_error;
        EXPECT_GE(error, 0.3 / 256);
        EXPECT_LE(error, 2.0 / 256);
    }
}

TEST(Estimates, OfSingleRaysStateTheSpreadOfTheirTile) {
    const std::array open = {0.0}, blocked = {1.0};
    std::vector<PixelSpread> pixels(48, pixel_spread(open, 1));
    pixels.insert(pixels.end(), 16, pixel_spread(blocked, 1));
    for (const Estimate& estimate : moderated_estimates(pixels, {}))
        EXPECT_NEAR(estimate.standard_error, std::sqrt(0.75 * 0.25), 0.005);
}

TEST(Estimates, OfALuckyHalfAreThoseOfItsNeighbours) {
    // All blocks of one pixel of a penumbra agree by chance; its neighbours show how little that means.
    const std::array lucky = {4.0, 4.0, 4.0, 4.0, 4.0, 4.0, 4.0, 4.0};
    const std::array usual = {5.0, 4.0, 3.0, 4.0, 4.0, 5.0, 4.0, 3.0};
    std::vector<PixelSpread> pixels(64, pixel_spread(usual, 64));
    pixels[0] = pixel_spread(lucky, 64);
    const std::vector<Estimate> estimates = moderated_estimates(pixels, {});
    EXPECT_GT(estimates[0].standard_error, 0.9 * estimates[1].standard_error);
    // A whole tile that agrees still states a part of the usual error of scenes.
    std::fill(pixels.begin(), pixels.end(), pixel_spread(lucky, 64));
    EXPECT_GT(moderated_estimates(pixels, {})[0].standard_error, 0.5 / 64);
}

TEST(Estimates, OfAgreeingPixelsFallAsTheirTileAgrees) {
    EXPECT_GT(error_of_agreement(256, 1, 1), 0.3 / 256);
    double before = 1;
    for (const int agreeing : {1, 8, 16, 32, 48, 60, 64}) {
        const double error = error_of_agreement(64, agreeing, 64);
        EXPECT_LT(error, before);
        EXPECT_DOUBLE_EQ(error_of_agreement(256, agreeing, 64), error / 4);
        before = error;
    }
    const std::array none = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const std::array many = {8.0, 8.0, 8.0, 8.0, 8.0, 8.0, 8.0, 8.0};
    const std::array most = {32.0, 32.0, 32.0, 32.0, 32.0, 32.0, 32.0, 31.0};
    const auto first_error = [](const std::vector<std::span<const double>>& tile) {
        std::vector<PixelSpread> pixels;
        for (const auto sums : tile) pixels.push_back(pixel_spread(sums, 256));
        return moderated_estimates(pixels, {})[0].standard_error;
    };
    EXPECT_GT(first_error({none, none, many, many}), first_error({none, none, none, none}));
    // Mostly blocked pixels across an edge of depth do not change the error.
    EXPECT_DOUBLE_EQ(first_error({none, none, most, most}), first_error({none, none}));
}

}  // namespace
}  // namespace aoscore
