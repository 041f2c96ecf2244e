#include "files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <limits>

namespace aoscore {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::kLinear;
using testing::kSrgb;
using testing::output_dir;
using testing::random_visibility;
using testing::same_bits;

const ImageF kFirst = random_visibility(20, 10, 1), kSecond = random_visibility(20, 10, 2),
             kThird = random_visibility(20, 10, 3);

VisibilityFile visibility_of(const std::vector<ChannelView>& channels) {
    const auto path = output_dir() / "image.exr";
    write_exr(path, channels, {});
    return read_visibility(path, kLinear);
}

/// A PNG of the kinds that encode_png_gray does not write, by libpng's simple interface.
void write_png(const std::filesystem::path& path, png_uint_32 format, int width, int height,
               const void* pixels) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = format;
    ASSERT_NE(png_image_write_to_file(&image, path.c_str(), 0, pixels, 0, nullptr), 0) << image.message;
}

TEST(VisibilityFile, PrefersYAndReadsItsMaskAndStandardError) {
    ImageF mask(20, 10, 1.0F);
    mask.at(3, 4) = 0;
    mask.at(5, 6) = std::numeric_limits<float>::quiet_NaN();
    const VisibilityFile file = visibility_of(
        {{"Y", &kFirst}, {"V0.Y", &kSecond}, {"V1.Y", &kThird}, {"SE.Y", &kSecond}, {"mask.Y", &mask}});
    EXPECT_EQ(file.channel, "Y");
    EXPECT_TRUE(same_bits(file.visibility, kFirst));
    EXPECT_TRUE(same_bits(file.standard_error, kSecond));
    EXPECT_EQ(std::count(file.mask.pixels.begin(), file.mask.pixels.end(), 1), 198);
    EXPECT_EQ(file.mask.at(3, 4) + file.mask.at(5, 6), 0);
}

TEST(VisibilityFile, OfAFilteredMethodIsItsOutputAndSaysSo) {
    const VisibilityFile file = visibility_of({{"Y", &kFirst}, {"raw.Y", &kSecond}});
    EXPECT_EQ(file.channel, "Y");
    EXPECT_THAT(file.why, HasSubstr("behind its filter"));
    EXPECT_TRUE(same_bits(file.visibility, kFirst));
    EXPECT_THAT(testing::file_error_of([] {
                    visibility_of({{"first.Y", &kFirst}, {"raw.Y", &kSecond}});
                }),
                HasSubstr("more than one channel"));
}

TEST(VisibilityFile, WithoutMaskAllPixelsCountAndNoStandardErrorIsKnown) {
    const VisibilityFile file = visibility_of({{"Y", &kFirst}});
    EXPECT_EQ(std::count(file.mask.pixels.begin(), file.mask.pixels.end(), 1), 200);
    EXPECT_TRUE(file.mask.same_size(file.visibility));
    EXPECT_TRUE(file.standard_error.empty());
}

TEST(VisibilityFile, TakesTheOnlyChannelWhateverItsName) {
    EXPECT_EQ(visibility_of({{"hbao.Y", &kFirst}}).channel, "hbao.Y");
    EXPECT_EQ(visibility_of({{"occlusion", &kFirst}, {"A", &kSecond}, {"mask.Y", &kThird}}).channel,
              "occlusion");
}

TEST(VisibilityFile, TakesRedOfGrayButRefusesColour) {
    const VisibilityFile gray =
        visibility_of({{"R", &kFirst}, {"G", &kFirst}, {"B", &kFirst}, {"A", &kSecond}});
    EXPECT_EQ(gray.channel, "R");
    EXPECT_TRUE(same_bits(gray.visibility, kFirst));
    EXPECT_THAT(testing::file_error_of([] {
                    visibility_of({{"R", &kFirst}, {"G", &kFirst}, {"B", &kSecond}});
                }),
                AllOf(HasSubstr("image.exr"), HasSubstr("R, G, B"), HasSubstr("valid: one layer named AO")));
}

TEST(VisibilityFile, FindsTheLayerThatBlenderCallsAmbientOcclusion) {
    for (const std::string layer : {"ViewLayer", "View Layer", "RenderLayer"}) {
        const VisibilityFile file = visibility_of({{layer + ".AO.R", &kFirst},
                                                   {layer + ".AO.G", &kFirst},
                                                   {layer + ".AO.B", &kFirst},
                                                   {layer + ".Combined.R", &kSecond},
                                                   {layer + ".Depth.Z", &kThird}});
        EXPECT_EQ(file.channel, layer + ".AO.R");
        EXPECT_TRUE(same_bits(file.visibility, kFirst));
    }
}

TEST(VisibilityFile, RefusesWhatIsAmbiguousAndNamesTheChannels) {
    EXPECT_THAT(testing::file_error_of([] {
                    visibility_of({{"a.AO.R", &kFirst}, {"b.AO.R", &kSecond}});
                }),
                AllOf(HasSubstr("more than one"), HasSubstr("a.AO.R, b.AO.R")));
    EXPECT_THAT(testing::file_error_of([] {
                    visibility_of({{"Z", &kFirst}, {"N.X", &kSecond}});
                }),
                AllOf(HasSubstr("no channel"), HasSubstr("N.X"), HasSubstr("Z")));
}

TEST(VisibilityFile, ALayerOfAmbientOcclusionGoesBeforeAGreyPicture) {
    const VisibilityFile file = visibility_of({{"R", &kSecond},
                                               {"G", &kSecond},
                                               {"B", &kSecond},
                                               {"AO.R", &kFirst},
                                               {"AO.G", &kFirst},
                                               {"AO.B", &kFirst}});
    EXPECT_EQ(file.channel, "AO.R");
    EXPECT_EQ(file.why, "named as ambient occlusion");
    EXPECT_TRUE(file.warnings.empty());
}

TEST(VisibilityFile, AnOcclusionInColourIsReadWithAWarning) {
    const VisibilityFile file = visibility_of({{"AO.R", &kFirst}, {"AO.G", &kSecond}, {"AO.B", &kFirst}});
    EXPECT_EQ(file.channel, "AO.R");
    EXPECT_THAT(file.warnings, ::testing::ElementsAre(HasSubstr("not in grey")));
}

TEST(VisibilityFile, DepthIsNeverVisibilityWhateverItsName) {
    const ImageF depth = random_visibility(20, 10, 4);
    const std::vector<std::vector<ChannelView>> files = {
        {{"Z", &depth}},
        {{"depth", &depth}},
        {{"Y", &depth}, {"Z", &depth}},  // as in this program's G-buffers
        {{"R", &kFirst},
         {"G", &kSecond},
         {"B", &kThird},
         {"SceneDepth.R", &depth},
         {"SceneDepth.G", &depth},
         {"SceneDepth.B", &depth}}};
    for (const auto& channels : files) {
        EXPECT_THAT(testing::file_error_of([&] { visibility_of(channels); }),
                    HasSubstr("no channel of visibility"));
    }
}

TEST(VisibilityFile, AGreyPictureAmongPassesOfALitOneIsNotTaken) {
    for (const char* pass : {"Shadow.R", "Diffuse.Y", "ViewLayer.Combined.R"}) {
        EXPECT_THAT(testing::file_error_of([&] {
                        visibility_of({{"R", &kFirst}, {"G", &kFirst}, {"B", &kFirst}, {pass, &kSecond}});
                    }),
                    HasSubstr("no channel of visibility"))
            << pass;
    }
    EXPECT_EQ(visibility_of({{"R", &kFirst}, {"G", &kFirst}, {"B", &kFirst}, {"Z", &kSecond}}).channel, "R");
}

TEST(VisibilityFile, OneOfSeveralUnknownPicturesIsNotTaken) {
    EXPECT_THAT(testing::file_error_of([] {
                    visibility_of({{"R", &kFirst}, {"G", &kFirst}, {"B", &kFirst}, {"mine", &kSecond}});
                }),
                AllOf(HasSubstr("more than one"), HasSubstr("R, mine")));
}

TEST(VisibilityFile, ATruthsRadiiHaveTheirOwnStandardErrors) {
    const auto path = output_dir() / "truth.exr";
    write_exr(path,
              std::vector<ChannelView>{{"Y", &kFirst},
                                       {"V0.Y", &kFirst},
                                       {"V1.Y", &kSecond},
                                       {"SE.Y", &kSecond},
                                       {"SE0.Y", &kSecond},
                                       {"SE1.Y", &kThird}},
              {});
    const auto error_of = [&](const char* channel) {
        return read_visibility(path, {.channel = channel, .coding = {}}).standard_error;
    };
    EXPECT_TRUE(same_bits(error_of(""), kSecond));
    EXPECT_TRUE(same_bits(error_of("V0.Y"), kSecond));
    EXPECT_TRUE(same_bits(error_of("V1.Y"), kThird));
    EXPECT_TRUE(error_of("SE.Y").empty());
}

TEST(VisibilityFile, RoundingDoesNotMakeAGreyPictureColoured) {
    ImageF green = kFirst;
    for (float& value : green.pixels) value += 1e-3F;
    EXPECT_EQ(visibility_of({{"R", &kFirst}, {"G", &green}, {"B", &kFirst}}).channel, "R");
}

TEST(VisibilityFile, AMaskOfItsOwnIsFoundByNameOrAsTheOnlyGrey) {
    const auto path = output_dir() / "mask.exr";
    ImageF left(20, 10), zero(20, 10);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) left.at(x, y) = 1;
    }
    const auto count = [&](const std::vector<ChannelView>& channels, const std::string& channel = {}) {
        write_exr(path, channels, {});
        const Mask mask = read_mask(path, channel);
        return std::count(mask.pixels.begin(), mask.pixels.end(), 1) * mask.at(0, 0);
    };
    EXPECT_EQ(count({{"Y", &left}}), 100);
    EXPECT_EQ(count({{"A", &zero}, {"B", &left}, {"G", &left}, {"R", &left}}), 100);
    EXPECT_EQ(count({{"AO.Y", &zero}, {"Y", &zero}, {"mask.Y", &left}}), 100);
    EXPECT_EQ(count({{"a", &zero}, {"b", &left}}, "b"), 100);
    EXPECT_THAT(testing::file_error_of([&] {
                    count({{"a1", &zero}, {"b1", &left}});
                }),
                HasSubstr("--mask-channel"));
}

TEST(VisibilityFile, EightBitsAreValueBy255UnlessTheyAreSrgb) {
    const auto path = output_dir() / "levels.png";
    Image<std::uint8_t> levels(16, 16);
    for (std::size_t i = 0; i < 256; ++i) levels.pixels[i] = static_cast<std::uint8_t>(i);
    testing::write_bytes(path, encode_png_gray(levels));
    const VisibilityFile linear = read_visibility(path, kLinear), decoded = read_visibility(path, kSrgb);
    for (std::size_t i = 0; i < 256; ++i) {
        const double coded = static_cast<double>(i) / 255;
        EXPECT_EQ(linear.visibility.pixels[i], static_cast<float>(i) / 255.0F) << i;
        EXPECT_NEAR(decoded.visibility.pixels[i],
                    coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4), 1e-6)
            << i;
    }
}

TEST(VisibilityFile, SrgbLeavesFloatsAlone) {
    const auto path = output_dir() / "image.exr";
    write_exr(path, std::vector<ChannelView>{{"Y", &kFirst}}, {});
    EXPECT_TRUE(same_bits(read_visibility(path, kSrgb).visibility, kFirst));
}

TEST(VisibilityFile, AlphaNeitherDarkensNorMasks) {
    const auto path = output_dir() / "alpha.png";
    const std::vector<std::uint8_t> pixels = {200, 128, 100, 0};  // gray, alpha, gray, alpha
    write_png(path, PNG_FORMAT_GA, 2, 1, pixels.data());
    const VisibilityFile file = read_visibility(path, kLinear);
    EXPECT_EQ(file.channel, "Y");
    EXPECT_EQ(file.visibility.pixels, (std::vector<float>{200 / 255.0F, 100 / 255.0F}));
    EXPECT_EQ(file.mask.pixels, (std::vector<std::uint8_t>{1, 1}));
}

TEST(VisibilityFile, SixteenBitsAreValueBy65535) {
    const auto path = output_dir() / "deep.png";
    const std::vector<std::uint16_t> pixels = {0x1234, 0xffff};
    write_png(path, PNG_FORMAT_LINEAR_Y, 2, 1, pixels.data());
    const ImageFile file = read_image(path);
    EXPECT_TRUE(file.integers);
    EXPECT_EQ(file.channels.at(0).pixels, (std::vector<float>{0x1234 / 65535.0F, 1.0F}));
}

TEST(VisibilityFile, PfmIsReadTopRowFirst) {
    const auto path = output_dir() / "image.pfm";
    std::string bytes = "Pf\n1 2\n-1.0\n";
    for (const float value : {0.25F, 0.75F})
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    testing::write_bytes(path, bytes);
    EXPECT_EQ(read_visibility(path, kLinear).visibility.pixels, (std::vector<float>{0.75F, 0.25F}));
}

}  // namespace
}  // namespace aoscore
