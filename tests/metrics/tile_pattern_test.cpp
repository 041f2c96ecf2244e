#include "metrics/analysis/tile_pattern.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <random>

namespace aoscore {
namespace {

using testing::Pair;

constexpr int kSide = 256;

// A pair whose error has this standard deviation and repeats after so many pixels.
Pair repeating(int period_px, float deviation) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal(0, deviation);
    std::vector<float> values(static_cast<std::size_t>(period_px * period_px));
    for (float& value : values) value = normal(random);
    Pair pair(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            pair.test.at(x, y) = values[static_cast<std::size_t>(y % period_px * period_px + x % period_px)];
        }
    }
    return pair;
}

TEST(TilePattern, IsTheSizeOfWhatRepeatsWithTheTile) {
    const double pattern = *tile_pattern(repeating(kTile_px, 0.1F).input());
    EXPECT_GT(pattern, 0.05);
    EXPECT_LT(pattern, 0.15);
    Pair twice = repeating(kTile_px, 0.1F);
    for (float& error : twice.test.pixels) error *= 2;
    EXPECT_NEAR(*tile_pattern(twice.input()), 2 * pattern, 1e-6);
}

TEST(TilePattern, IsNoneInNoiseAndNoneAtAnEdge) {
    EXPECT_LT(*tile_pattern(repeating(kSide, 0.1F).input()), 0.02) << "noise, as large as the pattern was";
    Pair edge(kSide, kSide);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) edge.test.at(x, y) = x + y < kSide ? 0.0F : 1.0F;
    }
    EXPECT_LT(*tile_pattern(edge.input()), 1e-3);
}

TEST(TilePattern, CountsValidPixelsAlone) {
    Pair pair = repeating(kTile_px, 0.1F);
    const double pattern = *tile_pattern(pair.input());
    for (int y = 0; y < kSide; ++y) {
        for (int x = kSide / 2; x < kSide; ++x) {
            pair.valid.at(x, y) = 0;
            pair.test.at(x, y) = 1e6F;
        }
    }
    EXPECT_NEAR(*tile_pattern(pair.input()), pattern, 0.01);
    pair.valid = Mask(kSide, kSide, 0);
    EXPECT_FALSE(tile_pattern(pair.input()));
}

}  // namespace
}  // namespace aoscore
