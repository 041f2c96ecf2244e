#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
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

/// So many random tiles of a picture, all where it has fewer, always the same ones.
std::vector<Tile> random_tiles(int width, int height, std::size_t count);

/// A tile, and where it lies on a curve through all tiles of a picture on which neighbours are neighbours.
struct SpreadTile {
    Tile tile;
    std::size_t place;
};

/// All tiles of a picture, in an order whose first ones, however many, are spread evenly over it, each at
/// random within its part: means over such tiles are nearer to that of all than means over random ones.
/// Always the same order.
std::vector<SpreadTile> spread_tiles(int width, int height);

/// Consecutive tiles that one thread does with the same buffers: enough to spare allocations, few enough to
/// share the work evenly.
inline std::size_t tiles_at_a_time(std::size_t tiles) {
    return std::clamp<std::size_t>(tiles / 64, 1, 16);
}

/// The tiles of a picture in groups of so many.
class TileGroups {
  public:
    TileGroups(int width, int height)
        : tiles_(tiles_of(width, height)), size_(tiles_at_a_time(tiles_.size())) {}

    std::size_t count() const { return (tiles_.size() + size_ - 1) / size_; }
    std::span<const Tile> group(std::size_t g) const {
        return std::span(tiles_).subspan(g * size_, std::min(size_, tiles_.size() - g * size_));
    }

  private:
    std::vector<Tile> tiles_;
    std::size_t size_;
};

}  // namespace aoscore
