// Tests EXR files of kinds that only other programs write.
#include "support/foreign_exr.h"

#include "files.h"

#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace aoscore {
namespace {

using testing::kLinear;
using testing::output_dir;
using testing::random_visibility;
using testing::same_bits;

Imf::FrameBuffer frame_of(const std::string& channel, ImageF& image) {
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(image.pixels.data()), sizeof(float),
                                     sizeof(float) * static_cast<std::size_t>(image.width)));
    return frame;
}

TEST(ForeignExr, TilesAreRead) {
    const auto path = output_dir() / "tiles.exr";
    ImageF image = random_visibility(700, 333, 1);
    Imf::Header header(image.width, image.height);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(48, 40));
    {
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame_of("Y", image));
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    }
    EXPECT_TRUE(same_bits(read_visibility(path, kLinear).visibility, image));
}

TEST(ForeignExr, OfMipMapsTheFullSizeIsRead) {
    const auto path = output_dir() / "mipmaps.exr";
    ImageF image = random_visibility(64, 48, 1);
    Imf::Header header(image.width, image.height);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(16, 16, Imf::MIPMAP_LEVELS));
    {
        Imf::TiledOutputFile file(path.c_str(), header);
        for (int level = 0; level < file.numLevels(); ++level) {
            // Any picture of a quarter's size will do for the smaller ones.
            file.setFrameBuffer(frame_of("Y", image));
            file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        }
    }
    EXPECT_TRUE(same_bits(read_visibility(path, kLinear).visibility, image));
}

TEST(ForeignExr, PartsAreLayersButOnesOfAnotherSizeAreLeftOut) {
    const auto path = output_dir() / "parts.exr";
    const ImageF combined = random_visibility(30, 20, 1), ao = random_visibility(30, 20, 2);
    testing::write_parts(path, {{"Combined", {{"Combined.Z", &combined}}}, {"ViewLayer.AO", {{"R", &ao}}}},
                         30, 20);
    const ImageFile file = read_image(path);
    EXPECT_EQ(file.channel_names, (std::vector<std::string>{"Combined.Z", "ViewLayer.AO.R"}));
    const VisibilityFile visibility = read_visibility(path, kLinear);
    EXPECT_EQ(visibility.channel, "ViewLayer.AO.R");
    EXPECT_TRUE(same_bits(visibility.visibility, ao));
}

TEST(ForeignExr, TheFirstPartsNameCountsToo) {
    const auto path = output_dir() / "parts.exr";
    const ImageF ao = random_visibility(30, 20, 1), beauty = random_visibility(30, 20, 2);
    const auto grey = [](const ImageF& i) {
        return std::vector<ChannelView>{{"R", &i}, {"G", &i}, {"B", &i}};
    };
    testing::write_parts(path, {{"AO", grey(ao)}, {"beauty", grey(beauty)}}, 30, 20);
    for (const char* channel : {"", "AO.R", "ao.r", "AO"}) {
        const VisibilityFile file = read_visibility(path, {.channel = channel, .coding = {}});
        EXPECT_EQ(file.channel, "AO.R") << channel;
        EXPECT_TRUE(same_bits(file.visibility, ao)) << channel;
    }
    EXPECT_THAT(testing::file_error_of([&] { read_visibility(path, {.channel = "R", .coding = {}}); }),
                ::testing::HasSubstr("AO.R, beauty.R"));
    EXPECT_THAT(testing::file_error_of([&] { read_visibility(path, {.channel = "beuaty.R", .coding = {}}); }),
                ::testing::HasSubstr("did you mean beauty.R?"));
}

// In a crop, pixels of the display window that the file lacks do not count; in an overscan, pixels around the
// display window are no part of the picture.
TEST(ForeignExr, DataWindowsAreInPixelsOfTheDisplayWindow) {
    const auto folder = output_dir();
    const ImageF crop = random_visibility(10, 6, 1), overscan = random_visibility(40, 30, 2);
    testing::write_parts(folder / "crop.exr", {{"", {{"Y", &crop}}, 5, 7}}, 30, 20);
    const VisibilityFile cropped = read_visibility(folder / "crop.exr", kLinear);
    EXPECT_EQ(cropped.covered, (PixelRect{5, 7, 10, 6}));
    ASSERT_EQ(cropped.visibility.width, 30);
    ASSERT_EQ(cropped.visibility.height, 20);
    EXPECT_EQ(cropped.visibility.at(5, 7), crop.at(0, 0));
    EXPECT_EQ(cropped.visibility.at(14, 12), crop.at(9, 5));
    EXPECT_EQ(std::count(cropped.mask.pixels.begin(), cropped.mask.pixels.end(), 1), 60);
    EXPECT_EQ(cropped.mask.at(5, 7) + cropped.mask.at(14, 12), 2);

    testing::write_parts(folder / "overscan.exr", {{"", {{"Y", &overscan}}, -5, -4}}, 30, 20);
    const VisibilityFile whole = read_visibility(folder / "overscan.exr", kLinear);
    EXPECT_EQ(whole.covered, (PixelRect{0, 0, 30, 20}));
    EXPECT_EQ(whole.visibility.at(0, 0), overscan.at(5, 4));
    EXPECT_EQ(whole.visibility.at(29, 19), overscan.at(34, 23));

    testing::write_parts(folder / "outside.exr", {{"", {{"Y", &crop}}, 100, 100}}, 30, 20);
    EXPECT_THAT(testing::file_error_of([&] { read_image(folder / "outside.exr"); }),
                ::testing::HasSubstr("10x6 pixels at 100, 100 of a frame of 30x20"));
}

TEST(ForeignExr, PartsHaveDataWindowsOfTheirOwn) {
    const auto path = output_dir() / "parts.exr";
    const ImageF beauty = random_visibility(30, 20, 1), ao = random_visibility(10, 6, 2);
    testing::write_parts(path, {{"beauty", {{"R", &beauty}}}, {"AO", {{"Y", &ao}}, 5, 7}}, 30, 20);
    EXPECT_EQ(read_visibility(path, kLinear).covered, (PixelRect{5, 7, 10, 6}));
}

TEST(ForeignExr, DeepPartsAreLeftOutAndADeepImageIsRefusedInWords) {
    const auto path = output_dir() / "deep.exr";
    Imf::Header header(8, 8);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    {
        Imf::DeepScanLineOutputFile file(path.c_str(), header);
        std::vector<unsigned> counts(64, 1);
        std::vector<float> values(64, 0.5F);
        std::vector<float*> pointers;
        for (float& value : values) pointers.push_back(&value);
        Imf::DeepFrameBuffer frame;
        frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                                sizeof(unsigned), 8 * sizeof(unsigned)));
        frame.insert("Y", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                         8 * sizeof(float*), sizeof(float)));
        file.setFrameBuffer(frame);
        file.writePixels(8);
    }
    EXPECT_THAT(testing::file_error_of([&] { read_image(path); }), ::testing::HasSubstr("is a deep image"));
}

// OpenEXR's own writer makes luminance and chroma: Y in full resolution, RY and BY in a quarter of it.
TEST(ForeignExr, OfLuminanceAndChromaYIsReadWhereThePictureIsGrey) {
    const auto folder = output_dir();
    const ImageF image = random_visibility(20, 10, 1);
    const auto write = [&](const char* name, float red) {
        std::vector<Imf::Rgba> pixels;
        for (const float value : image.pixels) pixels.emplace_back(value * red, value, value, 1.0F);
        Imf::RgbaOutputFile file((folder / name).c_str(), image.width, image.height, Imf::WRITE_YC);
        file.setFrameBuffer(pixels.data(), 1, static_cast<std::size_t>(image.width));
        file.writePixels(image.height);
    };
    write("grey.exr", 1);
    write("colour.exr", 0.5F);
    const VisibilityFile grey = read_visibility(folder / "grey.exr", kLinear);
    EXPECT_EQ(grey.channel, "Y");
    for (std::size_t i = 0; i < image.size(); ++i)
        EXPECT_NEAR(grey.visibility.pixels[i], image.pixels[i], 0.004F) << "it keeps seven bits";
    EXPECT_EQ(read_image(folder / "grey.exr").channel_names, (std::vector<std::string>{"BY", "RY", "Y"}));
    EXPECT_THAT(testing::file_error_of([&] { read_visibility(folder / "colour.exr", kLinear); }),
                ::testing::HasSubstr("no channel of visibility among BY, RY, Y"));
    EXPECT_EQ(read_visibility(folder / "colour.exr", {.channel = "Y", .coding = {}}).channel, "Y");
    const std::string whole = read_file(folder / "grey.exr");
    testing::write_bytes(folder / "cut.exr", whole.substr(0, whole.size() - 60));
    EXPECT_THAT(testing::file_error_of([&] { read_image(folder / "cut.exr"); }),
                ::testing::HasSubstr("cut.exr"));
}

TEST(ForeignExr, HalfFloatsAreRead) {
    const auto path = output_dir() / "half.exr";
    std::vector<half> values = {half(0.25F), half(0.5F), half(1.0F), half(0.1F)};
    Imf::Header header(2, 2);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    {
        Imf::OutputFile file(path.c_str(), header);
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(values.data()), sizeof(half),
                                     2 * sizeof(half)));
        file.setFrameBuffer(frame);
        file.writePixels(2);
    }
    EXPECT_EQ(read_visibility(path, kLinear).visibility.pixels,
              (std::vector<float>{0.25F, 0.5F, 1.0F, half(0.1F)}));
}

}  // namespace
}  // namespace aoscore
