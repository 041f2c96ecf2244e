#include "metrics/analysis/likeness.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace aoscore {
namespace {

using testing::natural_pair;
using testing::Pair;

std::optional<Likeness> likeness_of(const Pair& pair) {
    LikenessSums sums;
    const auto width = static_cast<std::size_t>(pair.valid.width);
    for (int y = 0; y < pair.valid.height; ++y)
        sums.add({&pair.truth.at(0, y), width}, {&pair.test.at(0, y), width}, {&pair.valid.at(0, y), width});
    return sums.likeness();
}

TEST(Likeness, OfALinearCopyIsOneAndOfAnInvertedOneMinusOne) {
    Pair pair = natural_pair(53, 20);
    for (std::size_t i = 0; i < pair.test.size(); ++i) pair.test.pixels[i] = 0.5F * pair.truth.pixels[i];
    EXPECT_NEAR(likeness_of(pair)->correlation, 1, 1e-12);
    EXPECT_NEAR(likeness_of(pair)->unexplained(), 0, 1e-12);
    for (std::size_t i = 0; i < pair.test.size(); ++i) pair.test.pixels[i] = -pair.truth.pixels[i];
    EXPECT_NEAR(likeness_of(pair)->correlation, -1, 1e-12);
    EXPECT_EQ(likeness_of(pair)->unexplained(), 1);
}

// Two passes over the pixels that count: means first, then centred products.
TEST(Likeness, IsPearsonsOfThePixelsThatCountAndAreFinite) {
    Pair pair = natural_pair(53, 20);
    testing::mask_out(pair, 0.8);
    pair.truth.at(52, 3) = pair.test.at(0, 0) = std::numeric_limits<float>::quiet_NaN();
    pair.test.at(7, 7) = std::numeric_limits<float>::infinity();
    std::vector<double> truth, test;
    for (std::size_t i = 0; i < pair.valid.size(); ++i) {
        if (pair.valid.pixels[i] == 0) continue;
        if (!std::isfinite(pair.truth.pixels[i]) || !std::isfinite(pair.test.pixels[i])) continue;
        truth.push_back(double{pair.truth.pixels[i]});
        test.push_back(double{pair.test.pixels[i]});
    }
    const auto mean = [](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    const double truth_mean = mean(truth), test_mean = mean(test);
    double product = 0, of_truth = 0, of_test = 0, squared = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        product += (truth[i] - truth_mean) * (test[i] - test_mean);
        of_truth += (truth[i] - truth_mean) * (truth[i] - truth_mean);
        of_test += (test[i] - test_mean) * (test[i] - test_mean);
        squared += (truth[i] - test[i]) * (truth[i] - test[i]);
    }
    EXPECT_NEAR(likeness_of(pair)->correlation, product / std::sqrt(of_truth * of_test), 1e-12);
    EXPECT_NEAR(likeness_of(pair)->rmse, std::sqrt(squared / static_cast<double>(truth.size())), 1e-12);
}

TEST(Likeness, OfAConstantPictureIsNotThere) {
    Pair pair = natural_pair(53, 20);
    pair.test = ImageF(53, 20, 0.7F);
    EXPECT_FALSE(likeness_of(pair));
    pair = natural_pair(53, 20);
    pair.valid = Mask(53, 20, 0);
    EXPECT_FALSE(likeness_of(pair));
}

}  // namespace
}  // namespace aoscore
