// Tests the part of what one depth layer cannot show that an image has found.
#include "metrics/analysis/beyond_layer.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

constexpr int kSide = 32;

/// The upper and the lower half of a picture.
ImageF halves(float upper, float lower) {
    ImageF image(kSide, kSide, upper);
    for (int y = kSide / 2; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) image.at(x, y) = lower;
    }
    return image;
}

/// Above one layer shows all of an occlusion of .4, below .2 of .5.
std::optional<double> found_by(const ImageF& image) {
    const ImageF truth = halves(0.6F, 0.5F), one_layer = halves(0.4F, 0.2F);
    const Mask valid(kSide, kSide, 1);
    return found_beyond_layer({truth, image, valid}, one_layer);
}

TEST(FoundBeyondLayer, IsAllOfItInTheTruthAndNothingInTheBound) {
    EXPECT_NEAR(found_by(halves(0.6F, 0.5F)).value(), 1, 1e-6);
    EXPECT_NEAR(found_by(halves(0.6F, 0.8F)).value(), 0, 1e-6);
    EXPECT_NEAR(found_by(halves(0.6F, 0.65F)).value(), 0.5, 1e-6);
}

TEST(FoundBeyondLayer, DoesNotDependOnTheStrength) {
    EXPECT_NEAR(found_by(halves(0.8F, 0.75F)).value(), 1, 1e-6);
    EXPECT_NEAR(found_by(halves(0.9F, 0.95F)).value(), 0, 1e-6);
}

TEST(FoundBeyondLayer, IsUnknownWhereOneLayerIsEnough) {
    const ImageF truth = halves(0.6F, 0.5F), occlusion = halves(0.4F, 0.5F);
    const Mask valid(kSide, kSide, 1);
    EXPECT_FALSE(found_beyond_layer({truth, truth, valid}, occlusion));
    EXPECT_FALSE(found_by(halves(1, 1)));
}

}  // namespace
}  // namespace aoscore
