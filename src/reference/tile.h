#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aoscore {

/// Pixels [x0, x1) x [y0, y1): what one thread works on at a time.
struct Tile {
    int x0, y0, x1, y1;
};

/// Pixels of a tile's side. Larger tiles make more coherent packets of more distant starts.
inline constexpr int kTileSide = 8;

inline std::vector<Tile> tiles_of(int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += kTileSide) {
        for (int x = 0; x < width; x += kTileSide) {
            tiles.push_back({x, y, std::min(x + kTileSide, width), std::min(y + kTileSide, height)});
        }
    }
    return tiles;
}

/// Consecutive tiles that one thread does with the same buffers: enough to spare allocations, few enough to
/// share the work evenly.
inline std::size_t tiles_at_a_time(std::size_t tiles) {
    return std::clamp<std::size_t>(tiles / 64, 1, 16);
}

}  // namespace aoscore
