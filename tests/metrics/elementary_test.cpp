#include "metrics/analysis/mask_summary.h"
#include "metrics/analysis/occlusion_masks.h"
#include "metrics/evaluate.h"
#include "metrics/measures/noise.h"
#include "pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::natural_pair;
using testing::Pair;

MetricValue measured(const std::string& id, const Pair& pair) {
    return metric(id).measure(pair.input());
}

TEST(Bias, SeesAUniformShiftThatSsimHardlySees) {
    Pair pair(64, 64);
    pair.truth = ImageF(64, 64, 0.5F);
    pair.test = ImageF(64, 64, 0.54F);
    EXPECT_NEAR(*measured("bias", pair).value, 0.04, 1e-7);
    EXPECT_GT(*measured("ssim", pair).value, 0.99);
}

TEST(Bias, TurnsRoundWhenTruthAndTestAreSwapped) {
    Pair pair = natural_pair(64, 64);
    const double bias = *measured("bias", pair).value;
    EXPECT_GT(bias, 0.01);
    std::swap(pair.truth, pair.test);
    EXPECT_DOUBLE_EQ(*measured("bias", pair).value, -bias);
}

TEST(Errors, AreTheHandComputedOnes) {
    Pair pair(2, 2);
    pair.truth.pixels = {0, 0.5F, 1, 0.25F};
    pair.test.pixels = {0.5F, 0.5F, 0.75F, 0};
    pair.valid.pixels = {1, 1, 1, 0};
    EXPECT_DOUBLE_EQ(*measured("mae", pair).value, 0.25);
    EXPECT_DOUBLE_EQ(*measured("bias", pair).value, 0.25 / 3);
    EXPECT_DOUBLE_EQ(*measured("rmse", pair).value, std::sqrt(0.3125 / 3));
    EXPECT_DOUBLE_EQ(*measured("psnr", pair).value, -10 * std::log10(0.3125 / 3));
}

TEST(Psnr, HasNoValueForIdenticalImages) {
    Pair pair = natural_pair(32, 32);
    pair.test = pair.truth;
    EXPECT_FALSE(measured("psnr", pair).value);
    EXPECT_EQ(measured("psnr", pair).note, "the images are identical");
    EXPECT_EQ(*measured("rmse", pair).value, 0);
}

TEST(Psnr, TakesOneForThePeakWhateverTheImagesHold) {
    Pair dark(8, 8);
    dark.truth = ImageF(8, 8, 0.0F);
    dark.test = ImageF(8, 8, 0.1F);
    EXPECT_NEAR(*measured("psnr", dark).value, 20, 1e-6);
}

TEST(MaxError, NamesItsPixelAndBothValues) {
    Pair pair(40, 30);
    pair.truth = ImageF(40, 30, 0.5F);
    pair.test = pair.truth;
    pair.test.at(31, 7) = 0.125F;
    EXPECT_DOUBLE_EQ(*measured("max_error", pair).value, 0.375);
    EXPECT_EQ(measured("max_error", pair).note, "at pixel 31, 7: truth 0.5, test 0.125");
}

double missing_area(const Pair& pair, double threshold) {
    return measure_mask(pair.input(), MaskSide::missing, threshold).summary.area;
}

TEST(OcclusionMasks, HoldMissingAndFalseOcclusionBeyondTheThreshold) {
    Pair pair(5, 1);
    pair.truth.pixels = {0.5F, 0.5F, 0.5F, 0.5F, 0.5F};
    pair.test.pixels = {0.75F, 0.55F, 0.25F, 0.5F, 1.0F};
    pair.valid.pixels = {1, 1, 1, 1, 0};
    const OcclusionMasks masks = occlusion_masks(pair.input());
    EXPECT_EQ(masks.missing.pixels, (std::vector<std::uint8_t>{1, 0, 0, 0, 0}));
    EXPECT_EQ(masks.false_occlusion.pixels, (std::vector<std::uint8_t>{0, 0, 1, 0, 0}));
    EXPECT_DOUBLE_EQ(missing_area(pair, 0.1), 0.25);
    EXPECT_DOUBLE_EQ(measure_mask(pair.input(), MaskSide::false_occlusion, 0.1).summary.area, 0.25);
    EXPECT_DOUBLE_EQ(missing_area(pair, 0.01), 0.5);
}

TEST(OcclusionMasks, HaveNoAreaWithoutValidPixels) {
    Pair pair = natural_pair(16, 16);
    pair.valid = Mask(16, 16, 0);
    for (const MaskSide side : {MaskSide::missing, MaskSide::false_occlusion}) {
        const MeasuredMask mask = measure_mask(pair.input(), side, kMaskThreshold);
        EXPECT_EQ(mask.summary.area, 0);
        EXPECT_FALSE(mask.summary.mean);
        EXPECT_FALSE(mask.truth_noise);
    }
}

TEST(FinitePixels, CountsThoseThatEitherImageSpoils) {
    Pair pair = natural_pair(16, 16);
    pair.truth.at(1, 1) = std::numeric_limits<float>::quiet_NaN();
    pair.test.at(1, 1) = std::numeric_limits<float>::quiet_NaN();
    pair.test.at(2, 2) = -std::numeric_limits<float>::infinity();
    pair.test.at(3, 3) = std::numeric_limits<float>::quiet_NaN();
    pair.valid.at(3, 3) = 0;
    std::size_t nonfinite = 99;
    const Mask finite = finite_pixels(pair.truth, pair.test, pair.valid, nonfinite);
    EXPECT_EQ(nonfinite, 2U);
    EXPECT_EQ(finite.at(1, 1) + finite.at(2, 2) + finite.at(3, 3), 0);
    EXPECT_EQ(std::count(finite.pixels.begin(), finite.pixels.end(), 1), 16 * 16 - 3);
}

// Compares a method that is off by .05 everywhere with truths of so many samples: the number of open rays
// of each pixel is binomial.
class Debiased : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Samples, Debiased, ::testing::Values(16, 64, 256));

TEST_P(Debiased, RmseIsTheTrueOneUnderTheNoiseOfTheTruth) {
    constexpr int kSize = 512;
    constexpr double kTrueRmse = 0.05;
    const int samples = GetParam();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> visibilities(0.2, 0.9);
    Pair pair(kSize, kSize);
    ImageF standard_error(kSize, kSize);
    for (std::size_t i = 0; i < pair.truth.size(); ++i) {
        const double visibility = visibilities(random);
        const double estimate =
            std::binomial_distribution<int>(samples, visibility)(random) / double(samples);
        pair.truth.pixels[i] = static_cast<float>(estimate);
        pair.test.pixels[i] = static_cast<float>(visibility + (i % 2 == 0 ? kTrueRmse : -kTrueRmse));
        standard_error.pixels[i] = static_cast<float>(std::sqrt(estimate * (1 - estimate) / (samples - 1)));
    }
    const MetricInput input = pair.input(&standard_error);
    const double raw = *metric("rmse").measure(input).value;
    const double debiased = *metric("rmse_debiased").measure(input).value;
    const double floor = noise_floor(standard_error, pair.valid)->rmse();
    EXPECT_NEAR(debiased, kTrueRmse, samples == 16 ? 0.001 : 0.0005);
    EXPECT_NEAR(raw, std::hypot(kTrueRmse, floor), 0.001);
    EXPECT_GT(raw, debiased + (samples == 16 ? 0.05 : 0.003));
}

TEST(DebiasedRmse, IsZeroWithANoteBelowTheNoiseFloor) {
    Pair pair = natural_pair(32, 32);
    pair.test = pair.truth;
    const ImageF standard_error(32, 32, 0.125F);
    const MetricValue value = metric("rmse_debiased").measure(pair.input(&standard_error));
    EXPECT_EQ(value.value, 0.0);
    EXPECT_THAT(value.note, HasSubstr("noise floor of 0.125"));
}

TEST(DebiasedRmse, HasNoValueWithoutAStandardError) {
    const MetricValue value = measured("rmse_debiased", natural_pair(32, 32));
    EXPECT_FALSE(value.value);
    EXPECT_THAT(value.note, HasSubstr("standard error"));
}

TEST(NoiseFloor, AveragesOverValidPixelsOnly) {
    ImageF standard_error(3, 1);
    standard_error.pixels = {0.1F, 0.3F, 9};
    Mask valid(3, 1, 1);
    valid.pixels[2] = 0;
    const auto floor = noise_floor(standard_error, valid);
    ASSERT_TRUE(floor);
    EXPECT_NEAR(floor->mean_standard_error, 0.2, 1e-7);
    EXPECT_NEAR(floor->mean_variance, 0.05, 1e-7);
    EXPECT_NEAR(floor->rmse(), std::sqrt(0.05), 1e-7);
    EXPECT_FALSE(noise_floor(standard_error, Mask(3, 1, 0)));
}

}  // namespace
}  // namespace aoscore
