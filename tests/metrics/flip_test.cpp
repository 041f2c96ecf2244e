#include "metrics/evaluate.h"
#include "pictures.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

using testing::natural_pair;
using testing::Pair;

double flip(const Pair& pair) {
    return *metric("flip").measure(pair.input()).value;
}

TEST(Flip, OfIdenticalImagesIsZeroAndOfBlackAndWhiteNearlyOne) {
    Pair pair = natural_pair(64, 64);
    pair.test = pair.truth;
    EXPECT_EQ(flip(pair), 0);
    pair.truth = ImageF(64, 64, 0.0F);
    pair.test = ImageF(64, 64, 1.0F);
    EXPECT_GT(flip(pair), 0.95);
    EXPECT_LE(flip(pair), 1);
}

TEST(Flip, IsTheSameForBothOrdersAndForATransposedPair) {
    const Pair pair = natural_pair(70, 50);
    Pair swapped = pair, transposed(50, 70);
    std::swap(swapped.truth, swapped.test);
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 70; ++x) {
            transposed.truth.at(y, x) = pair.truth.at(x, y);
            transposed.test.at(y, x) = pair.test.at(x, y);
        }
    }
    EXPECT_NEAR(flip(swapped), flip(pair), 1e-12);
    EXPECT_NEAR(flip(transposed), flip(pair), 1e-12);
}

TEST(Flip, OfAFlatPairDoesNotChangeWithTheMask) {
    Pair pair(64, 64);
    pair.truth = ImageF(64, 64, 0.5F);
    pair.test = ImageF(64, 64, 0.6F);
    const double whole = flip(pair);
    testing::mask_out(pair, 0.5);
    // The square root of a rounding error in the features is what is left.
    EXPECT_NEAR(flip(pair), whole, 1e-6);
}

TEST(Flip, CountsAPatternTooFineToBeSeenLessThanACoarseOneOfTheSameRmse) {
    const auto stripes_of = [](int width_px) {
        Pair pair(96, 96);
        for (int y = 0; y < 96; ++y) {
            for (int x = 0; x < 96; ++x) {
                pair.truth.at(x, y) = 0.5F;
                pair.test.at(x, y) = x / width_px % 2 == 0 ? 0.4F : 0.6F;
            }
        }
        return pair;
    };
    EXPECT_LT(flip(stripes_of(1)), 0.5 * flip(stripes_of(12)));
}

}  // namespace
}  // namespace aoscore
