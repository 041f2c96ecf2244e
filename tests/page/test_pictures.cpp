#include "core/files.h"
#include "image/image_file.h"
#include "page/document/base64.h"
#include "page/document/number_text.h"
#include "page/pictures/quantised_image.h"
#include "page/pictures/signal_picture.h"
#include "page/pictures/thumbnail.h"
#include "page/unpacking.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace aoscore {
namespace {

std::string from_base64(const std::string& text) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<unsigned>(kDigits.find(c));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
        }
    }
    return bytes;
}

/// Unpacks the values as the page's script does, written after the format's description.
std::vector<double> unpacked(const QuantisedImage& image) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t size = width * static_cast<std::size_t>(image.height);
    const std::string bytes = testing::inflated(image.data);
    EXPECT_EQ(bytes.size(), size * static_cast<std::size_t>(image.bytes));
    const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(bytes[i])); };
    const int modulus = image.bytes == 1 ? 256 : 65536;
    std::vector<int> codes(size);
    std::vector<double> values(size);
    for (std::size_t i = 0; i < size; ++i) {
        int residual = byte(i);
        if (image.bytes == 2) {
            const int folded = residual * 256 + byte(size + i);
            residual = folded % 2 == 0 ? folded / 2 : -(folded + 1) / 2;
        }
        const bool first_column = i % width == 0, first_row = i < width;
        const int left = first_column ? 0 : codes[i - 1], up = first_row ? 0 : codes[i - width];
        const int corner = first_column || first_row ? 0 : codes[i - width - 1];
        const int median = std::max(std::min(left, up), std::min(std::max(left, up), left + up - corner));
        codes[i] = ((residual + median) % modulus + modulus) % modulus;
        values[i] = codes[i] == modulus - 1 ? std::numeric_limits<double>::quiet_NaN()
                                            : image.low + image.step * codes[i];
    }
    return values;
}

void expect_within_half_a_step(const ImageF& image, const QuantisedImage& kept) {
    const std::vector<double> values = unpacked(kept);
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (std::isfinite(image.pixels[i])) {
            ASSERT_NEAR(values[i], double{image.pixels[i]}, kept.step / 2 + 1e-12) << i;
        } else {
            ASSERT_TRUE(std::isnan(values[i])) << i;
        }
    }
}

ImageF noisy_gradient(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    ImageF image(width, height);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const float slope = static_cast<float>(i) / static_cast<float>(image.size());
        image.pixels[i] = std::clamp(slope + static_cast<float>(random() % 1000) / 5000 - 0.1F, 0.0F, 1.0F);
    }
    return image;
}

TEST(Base64, MatchesTheVectorsOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(NumberText, HasNoNegativeZeroAndNoNan) {
    EXPECT_EQ(fixed_text(-0.00001, 4), "0.0000");
    EXPECT_EQ(fixed_text(-0.25, 2), "−0.25");
    EXPECT_EQ(fixed_text(std::nullopt, 2), "–");
    EXPECT_EQ(fixed_text(std::numeric_limits<double>::quiet_NaN(), 2), "–");
    EXPECT_EQ(fixed_text(std::numeric_limits<double>::infinity(), 2), "–");
    EXPECT_EQ(percent_text(0.1234), "12.34");
    EXPECT_EQ(count_text(2073600), "2\u202f073\u202f600");
    EXPECT_EQ(count_text(12), "12");
    EXPECT_EQ(ratio(1.0, 0.0), std::nullopt);
}

TEST(QuantisedImage, ComesBackWithinHalfAStepForAnyNumberOfLevels) {
    unsigned seed = 1;
    for (const int levels : {2, 64, 254, kLevelsOfOneByte, 256, 4096, kLevelsOfTwoBytes}) {
        for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {1, 7}, {61, 37}}) {
            const ImageF image = noisy_gradient(width, height, seed++);
            const QuantisedImage kept = quantise(image, 0, 1, levels);
            EXPECT_EQ(kept.bytes, levels <= kLevelsOfOneByte ? 1 : 2);
            EXPECT_DOUBLE_EQ(kept.step, 1.0 / (levels - 1));
            expect_within_half_a_step(image, kept);
        }
    }
}

TEST(QuantisedImage, KeepsItsEndsExactly) {
    ImageF image(2, 1);
    image.pixels = {0, 1};
    for (const int levels : {kLevelsOfOneByte, kLevelsOfTwoBytes}) {
        const std::vector<double> values = unpacked(quantise(image, 0, 1, levels));
        EXPECT_EQ(values[0], 0);
        EXPECT_NEAR(values[1], 1, 1e-15);
    }
}

TEST(QuantisedImage, HasACodeForWhatIsNoNumber) {
    ImageF image = noisy_gradient(9, 9, 3);
    image.pixels[0] = std::numeric_limits<float>::quiet_NaN();
    image.pixels[40] = std::numeric_limits<float>::infinity();
    image.pixels[80] = -std::numeric_limits<float>::infinity();
    for (const int levels : {kLevelsOfOneByte, kLevelsOfTwoBytes}) {
        expect_within_half_a_step(image, quantise(image, 0, 1, levels));
    }
}

TEST(QuantisedImage, WidensItsRangeForValuesOutsideIt) {
    ImageF image = noisy_gradient(8, 8, 4);
    image.pixels[3] = 1.5F;
    image.pixels[9] = -0.25F;
    const QuantisedImage kept = quantise(image, 0, 1, kLevelsOfOneByte);
    EXPECT_EQ(kept.low, -0.25);
    expect_within_half_a_step(image, kept);
}

TEST(QuantisedImage, HoldsAFlatImage) {
    const ImageF image(5, 4, 3.5F);
    expect_within_half_a_step(image, quantise(image, 3.5, 3.5, kLevelsOfOneByte));
}

/// The picture as its PNG file has it.
ImageFile read_back(const Picture& picture) {
    const std::filesystem::path path = testing::output_dir() / "picture.png";
    write_atomically(path, from_base64(picture.uri.substr(picture.uri.find(',') + 1)));
    return read_image(path);
}

TEST(SignalErrorPicture, GrowsBrighterWithTheAngleAndIsGrayWherePixelsDoNotCount) {
    const std::vector<double> degrees{0, 20, 45, 90, 90};
    SignalImage truth(3, ImageF(5, 1)), test = truth;
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        truth[2].pixels[i] = 1;
        test[0].pixels[i] = static_cast<float>(std::sin(degrees[i] * std::numbers::pi / 180));
        test[2].pixels[i] = static_cast<float>(std::cos(degrees[i] * std::numbers::pi / 180));
    }
    Mask valid(5, 1, 1);
    valid.pixels[4] = 0;
    const Signal& bent = signal("bent_normal");
    const ImageFile picture =
        read_back(signal_error_picture(bent, {truth, test, valid, ImageF(5, 1, 0.0F)}, 100));
    std::vector<float> brightness(5);
    for (const char* channel : {"R", "G", "B"}) {
        for (std::size_t i = 0; i < 5; ++i) brightness[i] += picture.channel(channel)->pixels[i];
    }
    EXPECT_NEAR(brightness[0], 4.0 / 255, 1e-6) << "the first colour of magma";
    EXPECT_LT(brightness[0], brightness[1]);
    EXPECT_LT(brightness[1], brightness[2]);
    EXPECT_NEAR(brightness[2], (252 + 253 + 191) / 255.0, 1e-5) << "the last one";
    EXPECT_EQ(brightness[3], brightness[2]) << "larger angles share it";
    EXPECT_NEAR(brightness[4], (0x6f + 0x6f + 0x76) / 255.0, 1e-5);
}

TEST(SignalErrorPicture, IsBlueWhereAConeIsTooNarrowAndRedWhereItIsTooWide) {
    const SignalImage truth(1, ImageF(3, 1, 0.8F));
    SignalImage test = truth;
    test[0].pixels = {0.3F, 0.8F, 1.3F};
    const ImageFile picture = read_back(
        signal_error_picture(signal("cone_angle"), {truth, test, Mask(3, 1, 1), ImageF(3, 1, 0.0F)}, 100));
    const ImageF &red = *picture.channel("R"), &blue = *picture.channel("B");
    EXPECT_GT(blue.pixels[0], red.pixels[0]);
    EXPECT_EQ(blue.pixels[1], red.pixels[1]);
    EXPECT_GT(red.pixels[2], blue.pixels[2]);
}

TEST(Thumbnail, IsTheMeanOfTheSquaresItCovers) {
    ImageF visibility(5, 2);
    visibility.pixels = {0, 1, 0.2F, 0.2F, 1, 1, 0, 0.2F, 0.2F, 1};
    const Picture picture = gray_thumbnail(visibility, 3);
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 1);
    const ImageF image = read_back(picture).channels.front();
    EXPECT_NEAR(image.at(0, 0), 128.0 / 255, 1e-6);
    EXPECT_NEAR(image.at(1, 0), 51.0 / 255, 1e-6);
    EXPECT_NEAR(image.at(2, 0), 1, 1e-6);
}

}  // namespace
}  // namespace aoscore
