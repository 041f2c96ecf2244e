// EXR files of the kinds that other programs write and ours does not.
#include "files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

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

TEST(ForeignExr, PartsAreLayersButOnesOfAnotherSizeAreLeftOut) {
    const auto path = output_dir() / "parts.exr";
    std::vector<ImageF> images = {random_visibility(30, 20, 1), random_visibility(30, 20, 2),
                                  random_visibility(15, 10, 3)};
    const std::vector<std::string> parts = {"Combined", "ViewLayer.AO", "crop"},
                                   channels = {"Combined.Z", "R", "Y"};
    std::vector<Imf::Header> headers;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Imath::Box2i frame({0, 0}, {29, 19});
        headers.emplace_back(frame, Imath::Box2i({0, 0}, {images[i].width - 1, images[i].height - 1}));
        headers.back().setName(parts[i]);
        headers.back().setType(Imf::SCANLINEIMAGE);
        headers.back().channels().insert(channels[i], Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Imf::OutputPart part(file, static_cast<int>(i));
            part.setFrameBuffer(frame_of(channels[i], images[i]));
            part.writePixels(images[i].height);
        }
    }
    const ImageFile file = read_image(path);
    EXPECT_EQ(file.channel_names, (std::vector<std::string>{"Combined.Z", "ViewLayer.AO.R"}));
    const VisibilityFile visibility = read_visibility(path, kLinear);
    EXPECT_EQ(visibility.channel, "ViewLayer.AO.R");
    EXPECT_TRUE(same_bits(visibility.visibility, images[1]));
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
