#include "files.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

namespace aoscore {
namespace {

using testing::file_error_of;
using ::testing::HasSubstr;
using testing::output_dir;
using testing::write_bytes;

std::string reading(const std::filesystem::path& path) {
    return file_error_of([&] { read_image(path); });
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
}

std::string png_chunk(const std::string& type_and_data) {
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(type_and_data.data()),
                           static_cast<uInt>(type_and_data.size()));
    return big_endian(static_cast<std::uint32_t>(type_and_data.size() - 4)) + type_and_data +
           big_endian(static_cast<std::uint32_t>(crc));
}

TEST(HostileImage, AbsentFileFolderAndEmptyFileAreErrors) {
    const auto folder = output_dir();
    EXPECT_THAT(reading(folder / "absent.exr"), HasSubstr("absent.exr: no such file"));
    EXPECT_THAT(reading(folder / "constant.null"), HasSubstr("no such file"));
    EXPECT_THAT(reading(folder), HasSubstr("not a regular file"));
    write_bytes(folder / "empty.exr", "");
    EXPECT_THAT(reading(folder / "empty.exr"), HasSubstr("empty.exr"));
}

TEST(HostileImage, GarbageIsAnErrorThatNamesTheFileWhateverItCallsItself) {
    const auto folder = output_dir();
    std::mt19937 random(5);
    std::string garbage(5000, '\0');
    for (char& byte : garbage) byte = static_cast<char>(random());
    for (const std::string extension : {"exr", "png", "jpg", "tif", "hdr", "pfm", "bmp", "txt"}) {
        const auto path = folder / ("garbage." + extension);
        write_bytes(path, garbage);
        EXPECT_THAT(reading(path), HasSubstr("garbage." + extension));
    }
}

TEST(HostileImage, EveryTruncationOfAnExrIsAnError) {
    const auto folder = output_dir();
    const ImageF y = testing::random_visibility(64, 48, 1);
    write_exr(folder / "whole.exr", std::vector<ChannelView>{{"Y", &y}}, {{"aoscore:seed", "1"}});
    const std::string whole = read_file(folder / "whole.exr");
    for (std::size_t size = 0; size < whole.size(); size += size < 600 ? 7 : 211) {
        write_bytes(folder / "cut.exr", whole.substr(0, size));
        EXPECT_THAT(reading(folder / "cut.exr"), HasSubstr("cut.exr")) << size << " of " << whole.size();
    }
}

TEST(HostileImage, EveryTruncationOfAPngIsAnError) {
    const auto folder = output_dir();
    Image<std::uint8_t> gray(64, 48);
    std::mt19937 random(3);
    for (std::uint8_t& level : gray.pixels) level = static_cast<std::uint8_t>(random());
    const std::string whole = encode_png_gray(gray);
    const std::size_t end_of_pixels =
        whole.size() - 16;  // The last chunk is empty, and the checksum before it.
    for (std::size_t size = 0; size < end_of_pixels; size += 37) {
        write_bytes(folder / "cut.png", whole.substr(0, size));
        EXPECT_THAT(reading(folder / "cut.png"), HasSubstr("cut.png")) << size << " of " << whole.size();
    }
}

TEST(HostileImage, FlippedBytesNeverCrash) {
    const auto folder = output_dir();
    const ImageF y = testing::random_visibility(32, 32, 1);
    write_exr(folder / "whole.exr", std::vector<ChannelView>{{"Y", &y}}, {});
    const std::string whole = read_file(folder / "whole.exr");
    std::mt19937 random(11);
    for (int trial = 0; trial < 300; ++trial) {
        std::string bytes = whole;
        for (int flips = 0; flips < 3; ++flips) bytes[random() % 500] = static_cast<char>(random());
        write_bytes(folder / "flipped.exr", bytes);
        try {
            read_image(folder / "flipped.exr");
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
        }
    }
}

TEST(HostileImage, HeaderThatClaimsHugeSizesIsRefusedBeforeAnythingIsAllocated) {
    const auto folder = output_dir();
    const auto png = [&](std::uint32_t width, std::uint32_t height) {
        const std::string header =
            "IHDR" + big_endian(width) + big_endian(height) + std::string("\x08\0\0\0\0", 5);
        write_bytes(folder / "huge.png",
                    "\x89PNG\r\n\x1a\n" + png_chunk(header) + png_chunk("IDAT") + png_chunk("IEND"));
        return reading(folder / "huge.png");
    };
    EXPECT_THAT(png(900'000, 900'000), HasSubstr("huge.png"));
    EXPECT_THAT(png(20'000, 100), HasSubstr("at most 16384x16384"));
    EXPECT_THAT(png(16'384, 16'384), HasSubstr("huge.png"));

    const ImageF y(16, 16);
    write_exr(folder / "small.exr", std::vector<ChannelView>{{"Y", &y}}, {});
    std::string bytes = read_file(folder / "small.exr");
    const std::string fifteen("\x0f\0\0\0\x0f\0\0\0", 8), huge("\xff\xff\x0f\0\xff\xff\x0f\0", 8);
    for (const char* window : {"dataWindow", "displayWindow"}) {
        const std::size_t at = bytes.find(fifteen, bytes.find(window));
        ASSERT_NE(at, std::string::npos);
        bytes.replace(at, 8, huge);
    }
    write_bytes(folder / "huge.exr", bytes);
    EXPECT_THAT(reading(folder / "huge.exr"), HasSubstr("huge.exr"));
}

TEST(HostileImage, ExrThatClaimsMoreValuesThanItsBytesCanHoldIsRefusedBeforeAnythingIsAllocated) {
    const auto folder = output_dir();
    {
        Imf::Header header(16, 16);
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
        std::vector<float> values(256, 0.5F);
        Imf::FrameBuffer pixels;
        pixels.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 64));
        Imf::TiledOutputFile file((folder / "tiled.exr").c_str(), header);
        file.setFrameBuffer(pixels);
        file.writeTile(0, 0);
    }
    read_image(folder / "tiled.exr");
    std::string bytes = read_file(folder / "tiled.exr");
    const std::size_t at = bytes.find(std::string("\x10\0\0\0\x10\0\0\0", 8), bytes.find("tiledesc"));
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 8, std::string("\x10\0\0\0\0\0\0\x01", 8));  // 1 GiB; OpenEXR refuses 2 of them itself
    write_bytes(folder / "huge.exr", bytes);
    EXPECT_THAT(reading(folder / "huge.exr"), HasSubstr("claims tiles of 16x16777216 pixels"));
}

TEST(HostileImage, ExrWhoseAttributeIsLongerThanTheFileIsRefusedBeforeAnythingIsAllocated) {
    const auto folder = output_dir();
    const ImageF y(16, 16);
    write_exr(folder / "small.exr", std::vector<ChannelView>{{"Y", &y}}, {{"note", "short"}});
    read_image(folder / "small.exr");
    const std::string whole = read_file(folder / "small.exr");
    const std::string size("\x05\0\0\0", 4);
    const std::size_t at = whole.find(size + "short");
    ASSERT_NE(at, std::string::npos);
    for (const std::string& claimed : {std::string("\0\0\0\x7f", 4), std::string("\xff\xff\xff\xff", 4)}) {
        std::string bytes = whole;
        bytes.replace(at, 4, claimed);
        write_bytes(folder / "long.exr", bytes);
        EXPECT_THAT(reading(folder / "long.exr"), HasSubstr("its attribute note claims"));
    }
}

TEST(HostileImage, ExrOfMoreLinesThanItsBytesCanHoldIsRefusedBeforeTheirTableIsAllocated) {
    const auto folder = output_dir();
    const ImageF y(16, 16);
    write_exr(folder / "small.exr", std::vector<ChannelView>{{"Y", &y}}, {});
    std::string bytes = read_file(folder / "small.exr");
    const std::size_t at = bytes.find(std::string("\x0f\0\0\0\x0f\0\0\0", 8), bytes.find("dataWindow")) + 4;
    bytes.replace(at, 4, std::string("\xff\xff\xff\x1f", 4));
    write_bytes(folder / "tall.exr", bytes);
    EXPECT_THAT(reading(folder / "tall.exr"), HasSubstr("claims a picture of 16x536870912 pixels"));
}

TEST(HostileImage, WhateverALibrarySaysTheErrorIsOneLine) {
    const auto folder = output_dir();
    const ImageF y = testing::random_visibility(64, 48, 1);
    write_exr(folder / "whole.exr", std::vector<ChannelView>{{"Y", &y}}, {});
    const std::string whole = read_file(folder / "whole.exr");
    for (std::size_t size = 0; size < whole.size(); size += 97) {
        write_bytes(folder / "cut.exr", whole.substr(0, size));
        EXPECT_THAT(reading(folder / "cut.exr"), ::testing::Not(HasSubstr("\n")));
    }
}

}  // namespace
}  // namespace aoscore
