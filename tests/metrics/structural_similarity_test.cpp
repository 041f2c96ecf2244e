#include "core/files.h"
#include "metrics/evaluate.h"
#include "pictures.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

namespace aoscore {
namespace {

using ::testing::HasSubstr;
using testing::mask_out;
using testing::natural_pair;
using testing::Pair;

double ssim(const Pair& pair) {
    return *metric("ssim").measure(pair.input()).value;
}

/// Computes SSIM by its definition, pixel by pixel and with centred sums.
double ssim_by_definition(const Pair& pair) {
    double sum = 0;
    int count = 0;
    for (int y = 5; y < pair.truth.height - 5; ++y) {
        for (int x = 5; x < pair.truth.width - 5; ++x) {
            if (pair.valid.at(x, y) == 0) continue;
            const auto windowed = [&](auto value) {
                double weighted = 0, weights = 0;
                for (int dy = -5; dy <= 5; ++dy) {
                    for (int dx = -5; dx <= 5; ++dx) {
                        if (pair.valid.at(x + dx, y + dy) == 0) continue;
                        const double weight = std::exp(-(dx * dx + dy * dy) / 4.5);
                        weights += weight;
                        weighted += weight * value(double{pair.truth.at(x + dx, y + dy)},
                                                   double{pair.test.at(x + dx, y + dy)});
                    }
                }
                return weighted / weights;
            };
            const double a = windowed([](double t, double) { return t; });
            const double b = windowed([](double, double s) { return s; });
            const double aa = windowed([&](double t, double) { return (t - a) * (t - a); });
            const double bb = windowed([&](double, double s) { return (s - b) * (s - b); });
            const double ab = windowed([&](double t, double s) { return (t - a) * (s - b); });
            sum += (2 * a * b + 1e-4) * (2 * ab + 9e-4) / ((a * a + b * b + 1e-4) * (aa + bb + 9e-4));
            ++count;
        }
    }
    return sum / count;
}

TEST(Ssim, EqualsItsDefinition) {
    const Pair pair = natural_pair(71, 83);
    EXPECT_NEAR(ssim(pair), ssim_by_definition(pair), 1e-12);
}

TEST(Ssim, EqualsItsDefinitionUnderAMask) {
    Pair pair = natural_pair(71, 83);
    mask_out(pair, 0.5);
    EXPECT_NEAR(ssim(pair), ssim_by_definition(pair), 1e-12);
}

TEST(Ssim, OfAnImageWithItselfIsOne) {
    Pair pair = natural_pair(64, 64);
    pair.test = pair.truth;
    EXPECT_DOUBLE_EQ(ssim(pair), 1);
    mask_out(pair, 0.4);
    EXPECT_DOUBLE_EQ(ssim(pair), 1);
}

TEST(Ssim, AgreesWithScikitImage) {
    const std::filesystem::path folder = testing::output_dir();
    const Pair pair = natural_pair(160, 121);
    const auto write = [&](const char* name, const ImageF& image) {
        std::ofstream file(folder / name, std::ios::binary);
        for (const float value : image.pixels)
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
    };
    write("truth.raw", pair.truth);
    write("test.raw", pair.test);
    const std::string command =
        fmt::format("cd '{}' && /usr/bin/python3 '{}' 160 121 truth.raw test.raw >ssim.txt 2>oracle.log",
                    folder.string(), AOSCORE_ORACLE);
    const int status = std::system(command.c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
        GTEST_SKIP() << "scikit-image is not there (Debian: python3-skimage)";
    }
    ASSERT_EQ(status, 0) << read_file(folder / "oracle.log");
    EXPECT_NEAR(ssim(pair), std::stod(read_file(folder / "ssim.txt")), 1e-9);
}

TEST(Ssim, HasNoValueForAnImageWithinTheBorder) {
    const MetricValue small = metric("ssim").measure(natural_pair(10, 400).input());
    EXPECT_FALSE(small.value);
    EXPECT_THAT(small.note, HasSubstr("border"));
    Pair pair = natural_pair(64, 64);
    pair.valid = Mask(64, 64, 0);
    pair.valid.at(4, 30) = 1;
    EXPECT_FALSE(metric("ssim").measure(pair.input()).value);
}

TEST(MsSsim, OfAnImageWithItselfIsOneAndNoiseLowersIt) {
    Pair pair = natural_pair(200, 190);
    pair.test = pair.truth;
    EXPECT_DOUBLE_EQ(*metric("ms_ssim").measure(pair.input()).value, 1);
    const double noisy = *metric("ms_ssim").measure(natural_pair(200, 190).input()).value;
    EXPECT_LT(noisy, 0.99);
    EXPECT_GT(noisy, 0.3);
}

// Flat images have full contrast-structure at each scale, so that only the coarsest scale's luminance is
// left.
TEST(MsSsim, OfAUniformShiftIsTheCoarsestLuminanceTermByItsExponent) {
    Pair pair(192, 176);
    pair.truth = ImageF(192, 176, 0.5F);
    pair.test = ImageF(192, 176, 0.75F);
    const double luminance = (2 * 0.5 * 0.75 + 1e-4) / (0.25 + 0.5625 + 1e-4);
    EXPECT_NEAR(*metric("ms_ssim").measure(pair.input()).value, std::pow(luminance, 0.1333), 1e-9);
}

// The values were computed by other programs: contrast-structure by scipy 1.10.1 (ndimage.gaussian_filter,
// sigma 1.5, truncate 3.5), the coarsest scale by scikit-image 0.19.3 (metrics.structural_similarity, as in
// AgreesWithScikitImage), halved by its transform.downscale_local_mean without an odd last row or column;
// gray levels by 255 in double precision.
TEST(MsSsim, AgreesWithScipyAndScikitImage) {
    struct Case {
        const char* name;
        int width, height;
        int (*truth)(int x, int y);
        int (*test)(int truth, int x, int y);
        double ms_ssim;
    };
    const Case cases[] = {
        {"stripes", 256, 192, [](int x, int y) { return (7 * x + 13 * y) % 256; },
         [](int level, int, int) { return level * 9 / 10 + 12; }, 0.9947469236718469},
        {"ramp of odd height", 250, 181, [](int x, int) { return x * 255 / 249; },
         [](int level, int, int) { return std::max(level - 25, 0); }, 0.9913723969715037},
        {"curves of odd sizes", 321, 243, [](int x, int y) { return (x * x + 3 * y * y) / 97 % 200 + 20; },
         [](int level, int x, int y) { return level * 4 / 5 + (x / 9 + y / 7) % 5 * 10; },
         0.9005699687908739},
    };
    for (const Case& c : cases) {
        Pair pair(c.width, c.height);
        for (int y = 0; y < c.height; ++y) {
            for (int x = 0; x < c.width; ++x) {
                const int level = c.truth(x, y);
                pair.truth.at(x, y) = static_cast<float>(level) / 255.0F;
                pair.test.at(x, y) = static_cast<float>(c.test(level, x, y)) / 255.0F;
            }
        }
        EXPECT_NEAR(*metric("ms_ssim").measure(pair.input()).value, c.ms_ssim, 1e-6) << c.name;
    }
}

TEST(MsSsim, HasNoValueForSmallImages) {
    const MetricValue value = metric("ms_ssim").measure(natural_pair(175, 300).input());
    EXPECT_FALSE(value.value);
    EXPECT_THAT(value.note, HasSubstr("176x176"));
}

TEST(MsSsim, TakesAnticorrelatedStructureForZeroAndSaysSo) {
    Pair pair = natural_pair(200, 190);
    for (std::size_t i = 0; i < pair.test.size(); ++i) pair.test.pixels[i] = 1 - pair.truth.pixels[i];
    const MetricValue value = metric("ms_ssim").measure(pair.input());
    EXPECT_EQ(value.value, 0.0);
    EXPECT_THAT(value.note, HasSubstr("anticorrelated"));
}

}  // namespace
}  // namespace aoscore
