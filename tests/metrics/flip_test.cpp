#include "metrics/evaluate.h"
#include "pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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
    // There remains the square root of a rounding error in the features.
    EXPECT_NEAR(flip(pair), whole, 1e-6);
}

/// Evaluates the paper's definition for grays literally: a filter's response is a double sum over its square
/// window, pixel by pixel; invalid pixels do not count in a mean, and have the value of the pixel itself in a
/// derivative.
class PixelByPixel {
  public:
    explicit PixelByPixel(const Pair& pair)
        : pair_(pair), truth_(luminances(pair.truth)), test_(luminances(pair.test)) {}

    double mean() const {
        double sum = 0, count = 0;
        for (int y = 0; y < pair_.valid.height; ++y) {
            for (int x = 0; x < pair_.valid.width; ++x) {
                if (pair_.valid.at(x, y) == 0) continue;
                sum += at(x, y);
                ++count;
            }
        }
        return sum / count;
    }

  private:
    static constexpr double kPixelsPerDegree = 67.02;
    static constexpr int kContrastRadius_px = 10, kFeatureRadius_px = 9;
    static double sigma_px() { return 0.5 * 0.082 * kPixelsPerDegree; }
    static double gaussian(int x, int y) {
        return std::exp(-(x * x + y * y) / (2 * sigma_px() * sigma_px()));
    }
    static double edge(int x, int y) { return -x * gaussian(x, y); }
    static double point(int x, int y) { return (x * x / (sigma_px() * sigma_px()) - 1) * gaussian(x, y); }
    static double contrast(int x, int y) {
        const double pi = std::numbers::pi;
        return std::exp(-pi * pi * (x * x + y * y) / (kPixelsPerDegree * kPixelsPerDegree) / 0.0047);
    }

    static double lightness(double y) {
        const double delta = 6.0 / 29;
        return 116 * (y > std::pow(delta, 3) ? std::cbrt(y) : y / (3 * delta * delta) + 4.0 / 29) - 16;
    }

    bool valid(int x, int y) const { return pair_.valid.at(clamp_x(x), clamp_y(y)) != 0; }
    int clamp_x(int x) const { return std::clamp(x, 0, pair_.valid.width - 1); }
    int clamp_y(int y) const { return std::clamp(y, 0, pair_.valid.height - 1); }
    static Image<double> luminances(const ImageF& image) {
        Image<double> result(image.width, image.height);
        for (std::size_t i = 0; i < image.size(); ++i) {
            const double v = std::clamp(double{image.pixels[i]}, 0.0, 1.0);
            result.pixels[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        }
        return result;
    }
    double luminance(const Image<double>& image, int x, int y) const {
        return image.at(clamp_x(x), clamp_y(y));
    }

    double seen(const Image<double>& image, int x, int y) const {
        double sum = 0, weight = 0;
        for (int v = -kContrastRadius_px; v <= kContrastRadius_px; ++v) {
            for (int u = -kContrastRadius_px; u <= kContrastRadius_px; ++u) {
                if (!valid(x + u, y + v)) continue;
                sum += contrast(u, v) * luminance(image, x + u, y + v);
                weight += contrast(u, v);
            }
        }
        return sum / weight;
    }

    /// Positive weights and negative ones are each scaled to a sum of 1.
    double derivative(const Image<double>& image, int x, int y, double (*kernel)(int, int), bool down) const {
        double positive = 0, negative = 0, plus = 0, minus = 0;
        for (int v = -kFeatureRadius_px; v <= kFeatureRadius_px; ++v) {
            for (int u = -kFeatureRadius_px; u <= kFeatureRadius_px; ++u) {
                const double weight = down ? kernel(v, u) : kernel(u, v);
                const bool there = valid(x + u, y + v);
                const double value = there ? luminance(image, x + u, y + v) : luminance(image, x, y);
                (weight > 0 ? plus : minus) += std::abs(weight);
                (weight > 0 ? positive : negative) += std::abs(weight) * value;
            }
        }
        return positive / plus - negative / minus;
    }
    double length(const Image<double>& image, int x, int y, double (*kernel)(int, int)) const {
        return std::hypot(derivative(image, x, y, kernel, false), derivative(image, x, y, kernel, true));
    }

    double at(int x, int y) const {
        // The largest difference is that of sRGB's green and blue, by their XYZ in IEC 61966-2-1.
        const auto lab = [](double fx, double fy, double fz) {
            const double l = lightness(fy), scale = 0.01 * l;
            return std::array<double, 3>{l, scale * 500 / 116 * (lightness(fx) - l),
                                         scale * 200 / 116 * (l - lightness(fz))};
        };
        const auto green = lab(0.3575761 / 0.95047, 0.7151522, 0.1191920 / 1.08883);
        const auto blue = lab(0.1804375 / 0.95047, 0.0721750, 0.9503041 / 1.08883);
        const double largest =
            std::pow(std::abs(green[0] - blue[0]) + std::hypot(green[1] - blue[1], green[2] - blue[2]), 0.7);
        const double hyab =
            std::pow(std::abs(lightness(seen(truth_, x, y)) - lightness(seen(test_, x, y))), 0.7);
        const double knee = 0.4 * largest;
        const double color =
            hyab < knee ? 0.95 * hyab / knee : 0.95 + 0.05 * (hyab - knee) / (largest - knee);
        const auto difference = [&](double (*kernel)(int, int)) {
            return std::abs(length(truth_, x, y, kernel) - length(test_, x, y, kernel));
        };
        const double feature = std::sqrt(std::max(difference(edge), difference(point)) / std::numbers::sqrt2);
        return std::pow(color, 1 - feature);
    }

    const Pair& pair_;
    Image<double> truth_, test_;  ///< luminance
};

TEST(Flip, IsWhatThePapersFiltersGivePixelByPixel) {
    const Pair small = natural_pair(45, 31);
    EXPECT_NEAR(flip(small), PixelByPixel(small).mean(), 1e-9);
}

TEST(Flip, IsWhatThePapersFiltersGiveAcrossTilesAndBesideInvalidPixels) {
    Pair wide = natural_pair(270, 12), high = natural_pair(12, 140);
    for (Pair* pair : {&wide, &high}) {
        EXPECT_NEAR(flip(*pair), PixelByPixel(*pair).mean(), 1e-9);
        testing::mask_out(*pair, 0.7);
        EXPECT_NEAR(flip(*pair), PixelByPixel(*pair).mean(), 1e-9);
    }
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
