#include "files.h"

#include <gtest/gtest.h>
#include <png.h>

namespace aoscore {
namespace {

using testing::output_dir;

int bits_of(const std::string& png) {
    return png.at(24);
}  // IHDR's fifth field.

Image<std::uint8_t> random_indices(int width, int height, std::uint32_t colours) {
    std::mt19937 random(9);
    Image<std::uint8_t> indices(width, height);
    for (std::uint8_t& index : indices.pixels) index = static_cast<std::uint8_t>(random() % colours);
    return indices;
}

class IndexedPng : public ::testing::TestWithParam<std::pair<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Colours, IndexedPng,
                         ::testing::Values(std::pair{1, 1}, std::pair{2, 1}, std::pair{3, 2}, std::pair{4, 2},
                                           std::pair{5, 4}, std::pair{16, 4}, std::pair{17, 8},
                                           std::pair{256, 8}));

TEST_P(IndexedPng, ComesBackInItsColoursWithNoMoreBitsThanNeeded) {
    const auto [colours, bits] = GetParam();
    std::vector<std::uint32_t> palette;
    for (int i = 0; i < colours; ++i) palette.push_back(static_cast<std::uint32_t>(0x102030 + i * 0x010307));
    const Image<std::uint8_t> indices = random_indices(37, 19, static_cast<std::uint32_t>(colours));
    const std::string png = encode_png_indexed(indices, palette);
    EXPECT_EQ(bits_of(png), bits);

    const auto path = output_dir() / "indexed.png";
    testing::write_bytes(path, png);
    const ImageFile file = read_image(path);
    ASSERT_EQ(file.channel_names, (std::vector<std::string>{"R", "G", "B"}));
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t rgb = palette[indices.pixels[i]];
        ASSERT_EQ(file.channels[0].pixels[i], static_cast<float>(rgb >> 16 & 255) / 255.0F);
        ASSERT_EQ(file.channels[1].pixels[i], static_cast<float>(rgb >> 8 & 255) / 255.0F);
        ASSERT_EQ(file.channels[2].pixels[i], static_cast<float>(rgb & 255) / 255.0F);
    }
}

TEST(GrayPng, ComesBackLevelByLevel) {
    const Image<std::uint8_t> levels = random_indices(301, 67, 256);
    const auto path = output_dir() / "gray.png";
    testing::write_bytes(path, encode_png_gray(levels));
    const ImageFile file = read_image(path);
    EXPECT_TRUE(file.integers);
    ASSERT_EQ(file.channels.size(), 1U);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        ASSERT_EQ(file.channels[0].pixels[i], static_cast<float>(levels.pixels[i]) / 255.0F);
    }
}

TEST(IndexedPngDefects, AreRefused) {
    const std::vector<std::uint32_t> two = {0, 0xffffff}, none, many(257);
    EXPECT_THROW(encode_png_indexed(random_indices(8, 8, 3), two), Error);
    EXPECT_THROW(encode_png_indexed(Image<std::uint8_t>(8, 8), none), Error);
    EXPECT_THROW(encode_png_indexed(Image<std::uint8_t>(8, 8), many), Error);
    EXPECT_THROW(encode_png_indexed(Image<std::uint8_t>(), two), Error);
    EXPECT_THROW(encode_png_gray(Image<std::uint8_t>()), Error);
}

}  // namespace
}  // namespace aoscore
