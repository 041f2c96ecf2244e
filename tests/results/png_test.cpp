#include "files.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

using testing::output_dir;

Image<std::uint8_t> random_levels(int width, int height) {
    std::mt19937 random(9);
    Image<std::uint8_t> levels(width, height);
    for (std::uint8_t& level : levels.pixels) level = static_cast<std::uint8_t>(random() % 256);
    return levels;
}

TEST(GrayPng, ComesBackLevelByLevel) {
    const Image<std::uint8_t> levels = random_levels(301, 67);
    const auto path = output_dir() / "gray.png";
    testing::write_bytes(path, encode_png_gray(levels));
    const ImageFile file = read_image(path);
    EXPECT_TRUE(file.integers);
    ASSERT_EQ(file.channels.size(), 1U);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        ASSERT_EQ(file.channels[0].pixels[i], static_cast<float>(levels.pixels[i]) / 255.0F);
    }
}

TEST(GrayPng, NeedsPixels) {
    EXPECT_THROW(encode_png_gray(Image<std::uint8_t>()), Error);
}

}  // namespace
}  // namespace aoscore
