#include "metrics/evaluate.h"
#include "pictures.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

using testing::Pair;
using testing::pair_of_levels;

/// Values that other implementations give for three pictures: SSIM by scikit-image (Gaussian weights,
/// population covariance, range 1), FLIP by its authors' own program.
struct Case {
    const char* name;
    Pair pair;
    double ssim, flip, rmse;
};

std::vector<Case> cases() {
    return {
        {"stripes",
         pair_of_levels(
             64, 64, [](int x, int y) { return (7 * x + 13 * y) % 256; },
             [](int r) { return r * 9 / 10 + 12; }),
         .993096247, .140174, .029195},
        {"ramp",
         pair_of_levels(
             64, 64, [](int x, int) { return 4 * x; }, [](int r) { return std::max(r - 25, 0); }),
         .888906189, .317927, .094394},
        {"const",
         pair_of_levels(
             64, 64, [](int, int) { return 128; }, [](int r) { return r + 10; }),
         .997177892, .149011, .039216},
    };
}

TEST(PublishedValues, SsimAgreesToOneInAMillion) {
    for (const Case& c : cases())
        EXPECT_NEAR(*evaluate(c.pair.input()).at("ssim").value, c.ssim, 1e-6) << c.name;
}

TEST(PublishedValues, RmseAgreesToOneInAMillion) {
    for (const Case& c : cases())
        EXPECT_NEAR(*evaluate(c.pair.input()).at("rmse").value, c.rmse, 1e-6) << c.name;
}

// The tolerance is wider than the printed digits: in single precision, the flat picture's features are a
// rounding error e, whose square root the definition takes.
TEST(PublishedValues, FlipAgreesToSinglePrecision) {
    for (const Case& c : cases())
        EXPECT_NEAR(*evaluate(c.pair.input()).at("flip").value, c.flip, 3e-5) << c.name;
}

}  // namespace
}  // namespace aoscore
