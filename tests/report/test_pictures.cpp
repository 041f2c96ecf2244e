#include "core/files.h"
#include "report/base64.h"
#include "report/colour_map.h"
#include "report/number_text.h"
#include "report/picture_encoding.h"
#include "results/image_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace aoscore {
namespace {

std::string decoded(const Picture& picture) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::string text = picture.uri.substr(picture.uri.find(',') + 1);
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

/// The picture as a viewer sees it, 0xRRGGBB.
Image<Rgb> seen(const Picture& picture) {
    const std::filesystem::path path = testing::output_dir() / "picture.png";
    write_atomically(path, decoded(picture));
    const ImageFile file = read_image(path);
    Image<Rgb> image(file.width, file.height);
    const std::size_t last = file.channels.size() >= 3 ? 1 : 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = file.channels[c * last].pixels[i];
            image.pixels[i] = image.pixels[i] << 8U | static_cast<Rgb>(std::lround(value * 255));
        }
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

TEST(ColourMap, EndsAtItsControlPointsAndIsSymmetricAroundZeroError) {
    EXPECT_EQ(colour_at(gray(), 0), 0x000000U);
    EXPECT_EQ(colour_at(gray(), 1), 0xffffffU);
    EXPECT_EQ(colour_at(gray(), 0.5), 0x808080U);
    EXPECT_EQ(colour_at(blue_red(), 0.5), 0xf7f7f7U);
    EXPECT_EQ(palette(magma(), 16).front(), magma().front());
    EXPECT_EQ(palette(magma(), 16).back(), magma().back());
    EXPECT_EQ(css_colour(kFalseOcclusionColour), "#0072b2");
}

TEST(ErrorPicture, IsRedWhereOcclusionIsMissingBlueWhereItIsFalse) {
    ImageF truth(4, 1, 0.5F), test(4, 1, 0.5F);
    Mask valid(4, 1, 1);
    test.pixels = {0.5F, 1.0F, 0.0F, 0.9F};
    valid.pixels[3] = 0;
    const Image<Rgb> image = seen(signed_error_picture(truth, test, valid));
    EXPECT_EQ(image.at(0, 0), 0xf7f7f7U);
    EXPECT_EQ(image.at(1, 0), blue_red().back());
    EXPECT_EQ(image.at(2, 0), blue_red().front());
    EXPECT_EQ(image.at(3, 0), kInvalidColour);
}

TEST(ErrorPicture, ShowsNonfinitePixelsInTheirOwnColour) {
    ImageF truth(2, 1, 0.5F), test(2, 1, 0.5F);
    test.pixels[1] = std::numeric_limits<float>::quiet_NaN();
    const Image<Rgb> image = seen(signed_error_picture(truth, test, Mask(2, 1, 1)));
    EXPECT_EQ(image.at(1, 0), kNonfiniteColour);
}

TEST(MaskPicture, LaysBothCausesOverTheTruth) {
    const ImageF truth(3, 1, 1.0F);
    Mask missing(3, 1), false_occlusion(3, 1);
    missing.pixels[0] = 1;
    false_occlusion.pixels[1] = 1;
    const Image<Rgb> image = seen(mask_picture(truth, missing, false_occlusion));
    EXPECT_EQ(image.at(0, 0), kMissingOcclusionColour);
    EXPECT_EQ(image.at(1, 0), kFalseOcclusionColour);
    EXPECT_EQ(image.at(2, 0), 0xf2f2f0U);
}

TEST(GrayPicture, IsLinearInVisibility) {
    ImageF visibility(3, 1);
    visibility.pixels = {0.0F, 0.2F, 1.0F};
    const Image<Rgb> image = seen(gray_picture(visibility));
    EXPECT_EQ(image.at(0, 0), 0x000000U);
    EXPECT_EQ(image.at(1, 0), 0x333333U);
    EXPECT_EQ(image.at(2, 0), 0xffffffU);
}

TEST(GrayPicture, RoundsToHalfTheTruthsNoiseAndKeepsBlackAndWhite) {
    ImageF visibility(4, 1);
    visibility.pixels = {0.0F, 0.46F, 0.54F, 1.0F};
    const Image<Rgb> image = seen(gray_picture(visibility, 0.1));
    EXPECT_EQ(image.at(0, 0), 0x000000U);
    EXPECT_EQ(image.at(1, 0), 0x808080U);
    EXPECT_EQ(image.at(2, 0), 0x808080U);
    EXPECT_EQ(image.at(3, 0), 0xffffffU);
}

TEST(Thumbnail, IsTheMeanOfTheSquaresItCovers) {
    ImageF visibility(5, 2);
    visibility.pixels = {0, 1, 0.2F, 0.2F, 1, 1, 0, 0.2F, 0.2F, 1};
    const Picture picture = gray_thumbnail(visibility, 3);
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 1);
    const Image<Rgb> image = seen(picture);
    EXPECT_EQ(image.at(0, 0), 0x808080U);
    EXPECT_EQ(image.at(1, 0), 0x333333U);
    EXPECT_EQ(image.at(2, 0), 0xffffffU);
}

}  // namespace
}  // namespace aoscore
