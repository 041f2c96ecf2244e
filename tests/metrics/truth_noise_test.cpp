// Compares with a truth without noise, which only an invented picture has: debiased and extrapolated values
// are right on average, and the stated half widths hold the converged value as often as they claim.
#include "metrics/evaluate.h"
#include "support/halved_scores.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <string>

namespace aoscore {
namespace {

constexpr int kWidth = 352, kHeight = 198;
constexpr int kSeeds = 200;

/// Open ground with contact shadows: slopes, edges, and a part where nothing occludes.
ImageF smooth_truth() {
    ImageF image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double wave = 0.5 + 0.5 * std::sin(x * 0.07) * std::cos(y * 0.05);
            const double edge = x % 88 < 12 ? 0.6 : 1.0;
            image.at(x, y) = y < kHeight / 5 ? 1.0F : static_cast<float>((0.25 + 0.75 * wave) * edge);
        }
    }
    return image;
}

/// A test image that is too bright in the shadows, with a halo beside the edges.
ImageF test_of(const ImageF& truth) {
    ImageF image = truth;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double brighter = std::pow(double{truth.at(x, y)}, 0.8);
            image.at(x, y) = static_cast<float>(x % 88 < 18 ? 0.85 * brighter : brighter);
        }
    }
    return image;
}

/// A half of the truth by `rays` independent rays a pixel.
ImageF half_of(const ImageF& truth, int rays, std::mt19937_64& random) {
    ImageF image(kWidth, kHeight);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        std::binomial_distribution<int> open(rays, double{truth.pixels[i]});
        image.pixels[i] = static_cast<float>(open(random)) / static_cast<float>(rays);
    }
    return image;
}

testing::HalvedScores measure(const ImageF& test, const ImageF& first, const ImageF& second) {
    ImageF mean = first;
    for (std::size_t i = 0; i < mean.size(); ++i) mean.pixels[i] = (first.pixels[i] + second.pixels[i]) / 2;
    Mask valid(kWidth, kHeight, 1);
    return testing::halved_scores(mean, first, second, test, valid);
}

class HalvesOfATruth : public ::testing::TestWithParam<int> {};

TEST_P(HalvesOfATruth, HoldTheConvergedValueOfEveryMetricAsOftenAsTheySay) {
    const ImageF truth = smooth_truth(), test = test_of(truth);
    Mask valid(kWidth, kHeight, 1);
    const std::map<std::string, MetricValue> converged = evaluate({truth, test, valid});
    std::map<std::string, int> held;
    std::map<std::string, double> sum, width;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        std::mt19937_64 random(static_cast<std::uint64_t>(seed));
        const ImageF first = half_of(truth, GetParam(), random), second = half_of(truth, GetParam(), random);
        const testing::HalvedScores measured = measure(test, first, second);
        for (const auto& [metric, half_width] : measured.noise) {
            // Without noise the metric that is not debiased is exact.
            const std::string exact = metric == "rmse_debiased" ? "rmse" : metric;
            const double error = *measured.values.at(metric).value - *converged.at(exact).value;
            held[metric] += std::abs(error) <= half_width;
            sum[metric] += error / kSeeds;
            width[metric] += half_width / kSeeds;
        }
    }
    std::string table =
        "| metric | share of seeds whose interval holds the converged value | mean half width | mean error "
        "|\n"
        "|---|---:|---:|---:|\n";
    for (const auto& [metric, count] : held)
        table += fmt::format("| {} | {:.3f} | {:.2g} | {:+.2g} |\n", metric,
                             static_cast<double>(count) / kSeeds, width[metric], sum[metric]);
    std::ofstream(testing::output_dir() / "coverage.md") << table;
    ASSERT_EQ(held.size(), 5U) << "all that are measured but MS-SSIM, which takes larger pictures";
    for (const auto& [metric, count] : held) {
        const double share = static_cast<double>(count) / kSeeds;
        EXPECT_GE(share, 0.92) << metric << " off by " << sum[metric] << ", half width " << width[metric];
        // Extrapolated values may lie in their intervals more often, which allow for errors that no seed
        // changes.
        const bool is_unbiased = aoscore::metric(metric).noise == Metric::Noise::taken_off;
        EXPECT_LE(share, is_unbiased ? 0.98 : 1)
            << metric << " off by " << sum[metric] << ", half width " << width[metric];
        EXPECT_LE(width[metric], is_unbiased ? 0.001 : 0.03) << metric;
    }
}

/// The mean difference from the converged value over a few seeds, with the noise taken off and without
/// halves.
struct MeanErrors {
    double taken_off = 0, plain = 0;
};

MeanErrors mean_errors(const Metric& metric, int rays_of_a_half) {
    constexpr int kFewSeeds = 4;
    const ImageF truth = smooth_truth(), test = test_of(truth);
    Mask valid(kWidth, kHeight, 1);
    const double converged = *metric.measure({truth, test, valid}).value;
    MeanErrors errors;
    for (int seed = 1; seed <= kFewSeeds; ++seed) {
        std::mt19937_64 random(static_cast<std::uint64_t>(seed));
        const ImageF first = half_of(truth, rays_of_a_half, random),
                     second = half_of(truth, rays_of_a_half, random);
        ImageF mean = first;
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean.pixels[i] = (first.pixels[i] + second.pixels[i]) / 2;
        const TruthHalves halves{first, second};
        MetricInput input{mean, test, valid};
        errors.plain += (*metric.measure(input).value - converged) / kFewSeeds;
        input.halves = &halves;
        const std::string id(metric.id);
        errors.taken_off += (*evaluate(input, {&id, 1}).at(id).value - converged) / kFewSeeds;
    }
    return errors;
}

// The noise of 2 x 128 rays has about the variance C2, which is where SSIM begins to notice it.
TEST(NoiseInWindows, IsTakenOffButForATenthOfWhatItDid) {
    int checked = 0;
    for (const Metric& metric : metrics()) {
        if (metric.noise != Metric::Noise::taken_off_in_windows) continue;
        for (const int rays : {128, 512}) {
            const MeanErrors errors = mean_errors(metric, rays);
            EXPECT_LT(std::abs(errors.taken_off), 0.1 * std::abs(errors.plain))
                << metric.id << ", " << rays << " rays a half: off by " << errors.taken_off << ", with noise "
                << errors.plain;
            ++checked;
        }
    }
    EXPECT_EQ(checked, 4);
}

INSTANTIATE_TEST_SUITE_P(RaysOfAHalf, HalvesOfATruth, ::testing::Values(512));

}  // namespace
}  // namespace aoscore
