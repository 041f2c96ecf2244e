#include "metrics/prepared_image.h"

#include "metrics/evaluate.h"
#include "metrics/intervals/block_errors.h"
#include "metrics/prepared_halves.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace aoscore {
namespace {

/// A pair with invalid pixels, some of which are no numbers, of odd size and larger than one area of FLIP.
testing::Pair masked_pair() {
    testing::Pair pair = testing::natural_pair(301, 213);
    testing::mask_out(pair, 0.7);
    for (std::size_t i = 0; i < pair.valid.size(); i += 3) {
        if (pair.valid.pixels[i] == 0)
            pair.truth.pixels[i] = pair.test.pixels[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return pair;
}

/// Half of it, as noise.
ImageF difference_of(const ImageF& first, const ImageF& second) {
    ImageF noise(first.width, first.height);
    for (std::size_t i = 0; i < noise.size(); ++i) noise.pixels[i] = (first.pixels[i] - second.pixels[i]) / 2;
    return noise;
}

struct Measured {
    MetricValue metric;
    MapSums maps;
};

Measured measured(const Metric& metric, MetricInput input) {
    Measured result;
    input.maps = &result.maps;
    result.metric = metric.measure(input);
    return result;
}

void expect_same(const Measured& a, const Measured& b, const std::string& what) {
    EXPECT_EQ(a.metric.value, b.metric.value) << what;
    EXPECT_EQ(a.metric.note, b.metric.note) << what;
    EXPECT_EQ(a.maps.flip_sums, b.maps.flip_sums) << what;
    EXPECT_EQ(a.maps.ssim_sums, b.maps.ssim_sums) << what;
    EXPECT_EQ(a.maps.ssim_weights, b.maps.ssim_weights) << what;
    EXPECT_EQ(a.maps.ms_ssim, b.maps.ms_ssim) << what;
    EXPECT_EQ(a.maps.ms_ssim_influences, b.maps.ms_ssim_influences) << what;
}

void expect_the_same_bits(const testing::Pair& pair) {
    const PreparedImage truth(pair.truth, pair.valid), test(pair.test, pair.valid);
    for (const Metric& metric : metrics()) {
        const std::string id(metric.id);
        const Measured plain = measured(metric, pair.input());
        MetricInput input = pair.input();
        input.prepared_truth = &truth;
        expect_same(measured(metric, input), plain, id + ", truth prepared");
        input.prepared_test = &test;
        expect_same(measured(metric, input), plain, id + ", both prepared");
        input.prepared_truth = nullptr;
        expect_same(measured(metric, input), plain, id + ", test prepared");
    }
}

TEST(PreparedImage, GivesEveryMetricTheSameBitsAsTheImageItself) {
    expect_the_same_bits(masked_pair());
    expect_the_same_bits(testing::natural_pair(301, 213));
}

TEST(PreparedImage, GivesTheSameWhereTheImageIsSmallerThanAWindow) {
    expect_the_same_bits(testing::natural_pair(9, 30));
}

// A truth is prepared once and compared with many images, of which none may affect the next.
TEST(PreparedImage, GivesTheSameWhateverItWasComparedWithBefore) {
    const testing::Pair pair = masked_pair();
    const PreparedImage truth(pair.truth, pair.valid);
    MetricInput input = pair.input();
    input.prepared_truth = &truth;
    const auto first = evaluate(input);
    const ImageF other(pair.test.width, pair.test.height, 0.5F);
    MetricInput between{pair.truth, other, pair.valid};
    between.prepared_truth = &truth;
    EXPECT_NE(evaluate(between).at("rmse").value, first.at("rmse").value);
    const auto again = evaluate(input);
    for (const auto& [id, metric] : first) EXPECT_EQ(again.at(id).value, metric.value) << id;
}

/// The sums of SSIM against a truth of halves with its noise, as evaluate() leaves them.
MapSums noisy_sums(const testing::Pair& pair, const ImageF& first, const ImageF& second,
                   const PreparedHalves* prepared) {
    MapSums noisy;
    const TruthHalves halves{first, second, nullptr, nullptr, prepared, &noisy};
    MetricInput input = pair.input();
    input.halves = &halves;
    evaluate(input);
    return noisy;
}

// They come from the pass that has the noise taken off. A second pass against the mean as it is knows nothing
// of halves.
TEST(PreparedHalves, GiveTheSumsOfSsimAgainstTheTruthAsItIs) {
    testing::Pair pair = masked_pair();
    const ImageF first = testing::natural_pair(301, 213, 3).truth,
                 second = testing::natural_pair(301, 213).truth;
    for (std::size_t i = 0; i < pair.truth.size(); ++i) {
        if (pair.valid.pixels[i] == 1) pair.truth.pixels[i] = (first.pixels[i] + second.pixels[i]) / 2;
    }
    for (float& value : pair.test.pixels) value = std::isnan(value) ? 0 : value;
    const MapSums plain = measured(metric("ssim"), pair.input()).maps;
    const PreparedHalves prepared(pair.truth, first, second, pair.valid);
    const MapSums noisy = noisy_sums(pair, first, second, &prepared);
    ASSERT_EQ(noisy.ssim_sums.size(), plain.ssim_sums.size());
    EXPECT_EQ(noisy.ssim_weights, plain.ssim_weights);
    for (std::size_t b = 0; b < plain.ssim_sums.size(); ++b)
        EXPECT_NEAR(noisy.ssim_sums[b], plain.ssim_sums[b], 1e-13 * plain.ssim_weights[b]) << "block " << b;
    EXPECT_EQ(noisy_sums(pair, first, second, nullptr).ssim_sums, noisy.ssim_sums) << "not prepared before";
    const PreparedImage without_noise(pair.truth, pair.valid, difference_of(first, second));
    MetricInput input = pair.input();
    input.prepared_truth = &without_noise;
    EXPECT_NE(measured(metric("ssim"), input).maps.ssim_sums, plain.ssim_sums) << "noise that does nothing";
}

}  // namespace
}  // namespace aoscore
