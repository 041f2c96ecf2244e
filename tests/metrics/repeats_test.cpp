#include "metrics/analysis/repeats.h"

#include "core/error.h"
#include "metrics/analysis/repeat_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace aoscore {
namespace {

constexpr int kSide = 48;

ImageF filled(float left, float right) {
    ImageF image(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) image.at(x, y) = x < kSide / 2 ? left : right;
    }
    return image;
}

Mask all_valid() {
    Mask mask(kSide, kSide);
    std::fill(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{1});
    return mask;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// Left nothing is hidden of an occlusion of .4; right .3 are hidden of .5.
HiddenOcclusion half_hidden() {
    return {filled(0.4F, 0.5F), filled(0, 0.3F)};
}

TEST(FoundOcclusion, APictureOfTheWholeFindsAllAndOneOfTheRestNothing) {
    const Mask valid = all_valid();
    for (const Findings findings : {Findings::free, Findings::within_hidden}) {
        const auto whole = found_occlusion(half_hidden(), filled(0.6F, 0.5F), valid, findings);
        ASSERT_TRUE(whole);
        EXPECT_NEAR(whole->strength, 1, 1e-6);
        EXPECT_NEAR(sum(whole->found) / sum(whole->hidden), 1, 1e-6);
        EXPECT_NEAR(sum(whole->kept) / sum(whole->visible), 1, 1e-6);
        EXPECT_DOUBLE_EQ(sum(whole->pixels), kSide * kSide / 2.0);
        EXPECT_DOUBLE_EQ(sum(whole->finders), sum(whole->pixels));
        const auto rest = found_occlusion(half_hidden(), filled(0.6F, 0.8F), valid, findings);
        ASSERT_TRUE(rest);
        EXPECT_NEAR(sum(rest->found) / sum(rest->hidden), 0, 1e-6);
        EXPECT_DOUBLE_EQ(sum(rest->finders), 0);
    }
}

// Of .3 that are hidden, the upper half of the picture finds two thirds and the lower half one third.
TEST(FoundOcclusion, APictureFindsPartsOfEachPixelsHiddenOcclusion) {
    ImageF uneven = filled(0.6F, 0.6F);
    for (int y = kSide / 2; y < kSide; ++y) {
        for (int x = kSide / 2; x < kSide; ++x) uneven.at(x, y) = 0.7F;
    }
    const auto found = found_occlusion(half_hidden(), uneven, all_valid(), Findings::within_hidden);
    ASSERT_TRUE(found);
    const double pixels = sum(found->pixels), mean = sum(found->parts) / pixels;
    EXPECT_NEAR(mean, 0.5, 1e-5);
    EXPECT_NEAR(sum(found->squared_parts) / pixels - mean * mean, 1.0 / 36, 1e-5);
}

TEST(FoundOcclusion, AFaintPictureFindsAtItsFittedStrengthWhatItFindsAtTheRightOne) {
    const auto faint =
        found_occlusion(half_hidden(), filled(1 - 0.1F, 1 - 0.125F), all_valid(), Findings::within_hidden);
    ASSERT_TRUE(faint);
    EXPECT_NEAR(faint->strength, 4, 1e-5);
    EXPECT_NEAR(sum(faint->found) / sum(faint->hidden), 0, 1e-6) << ".125 are less than the visible .2";
    EXPECT_NEAR(sum(faint->found_fitted) / sum(faint->hidden), 1, 1e-5);
}

TEST(FoundOcclusion, OnlyHeldWithinTheHiddenItIsNeverLessThanNothing) {
    const ImageF empty_right = filled(0.6F, 1);
    const auto free = found_occlusion(half_hidden(), empty_right, all_valid(), Findings::free);
    const auto held = found_occlusion(half_hidden(), empty_right, all_valid(), Findings::within_hidden);
    EXPECT_NEAR(sum(free->found) / sum(free->hidden), -0.2 / 0.3, 1e-6);
    EXPECT_NEAR(sum(held->found), 0, 1e-9);
}

TEST(FoundOcclusion, IsNotToldWhereNothingIsHiddenOrNoStrengthFits) {
    const Mask valid = all_valid();
    const HiddenOcclusion nothing{filled(0.4F, 0.5F), filled(0, 0)};
    EXPECT_FALSE(found_occlusion(nothing, filled(0.6F, 0.5F), valid, Findings::free));
    EXPECT_FALSE(found_occlusion(half_hidden(), filled(1, 0.5F), valid, Findings::free));
    EXPECT_THROW(found_occlusion(half_hidden(), ImageF(8, 8), valid, Findings::free), Error);
}

TEST(FoundOcclusion, CountsValidPixelsOnly) {
    Mask valid = all_valid();
    for (int y = 0; y < kSide / 2; ++y) {
        for (int x = 0; x < kSide; ++x) valid.at(x, y) = 0;
    }
    const auto found = found_occlusion(half_hidden(), filled(0.6F, 0.5F), valid, Findings::free);
    EXPECT_DOUBLE_EQ(sum(found->pixels), kSide * kSide / 4.0);
    EXPECT_DOUBLE_EQ(sum(valid_counts(valid)), kSide * kSide / 2.0);
}

TEST(Repeats, OverAllBlocksHaveTheSameValues) {
    Repeats repeats;
    repeats.counts = valid_counts(all_valid());
    repeats.variance = variance_sums({filled(0.2F, 0.5F), filled(0.3F, 0.9F)}, all_valid());
    repeats.of_truth =
        found_occlusion(half_hidden(), filled(0.6F, 0.6F), all_valid(), Findings::within_hidden);
    const Repeats all = over_all_blocks(repeats);
    EXPECT_GT(repeats.counts.size(), 1U);
    EXPECT_EQ(all.counts.size(), 1U);
    EXPECT_EQ(noise_over_seeds(all), noise_over_seeds(repeats));
    EXPECT_EQ(found_share(all.of_truth), found_share(repeats.of_truth));
    EXPECT_GT(found_share(all.of_truth).value(), 0);
    EXPECT_FALSE(all.of_layers);
}

TEST(Repeats, TheVarianceOverSeedsIsThatOfEachPixelAndNotOfThePicture) {
    // Four pictures with one edge, each darker by a step of .1: the edge is no noise.
    std::vector<ImageF> pictures;
    for (const float step : {0.0F, 0.1F, 0.2F, 0.3F}) pictures.push_back(filled(0.9F - step, 0.5F - step));
    const Mask valid = all_valid();
    const double variance = sum(variance_sums(pictures, valid)) / sum(valid_counts(valid));
    EXPECT_NEAR(variance, (2 * 0.15 * 0.15 + 2 * 0.05 * 0.05) / 3, 1e-6);
    EXPECT_NEAR(mean_image(pictures).at(0, 0), 0.75, 1e-6);
    EXPECT_THROW(variance_sums({pictures[0]}, valid), Error);
}

// Differences that change from pixel to pixel are noise, those of whole squares are bands.
TEST(Convergence, TellsBandsFromNoise) {
    const ImageF converged = filled(0.5F, 0.5F);
    ImageF noisy = converged, banded = converged;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            noisy.at(x, y) += (x + y) % 2 == 0 ? 0.1F : -0.1F;
            banded.at(x, y) += x / Convergence::kSide % 2 == 0 ? 0.1F : -0.1F;
        }
    }
    const auto root_mean = [](const std::vector<double>& squares, const Convergence& of) {
        return std::sqrt(sum(squares) / sum(of.counts));
    };
    const Convergence noise = convergence({noisy, noisy}, converged, all_valid());
    EXPECT_DOUBLE_EQ(sum(noise.counts), 2.0 * kSide * kSide) << "of both pictures";
    EXPECT_NEAR(root_mean(noise.squares, noise), 0.1, 1e-6);
    EXPECT_NEAR(root_mean(noise.bands, noise), 0, 1e-6);
    const Convergence bands = convergence({banded}, converged, all_valid());
    EXPECT_NEAR(root_mean(bands.squares, bands), 0.1, 1e-6);
    EXPECT_NEAR(root_mean(bands.bands, bands), 0.1, 1e-6);
    EXPECT_THROW(convergence({ImageF(1, 1)}, converged, all_valid()), Error);
}

}  // namespace
}  // namespace aoscore
