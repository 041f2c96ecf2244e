#include "reference/integrator/tile.h"

#include "core/sampling.h"

#include <cstdint>

namespace aoscore {

std::vector<Tile> random_tiles(int width, int height, std::size_t count) {
    std::vector<Tile> tiles = tiles_of(width, height);
    const auto key = [](const Tile& tile) {
        return mix_bits(static_cast<std::uint64_t>(tile.y0) << 32 | static_cast<std::uint32_t>(tile.x0));
    };
    std::sort(tiles.begin(), tiles.end(), [&](const Tile& a, const Tile& b) { return key(a) < key(b); });
    tiles.resize(std::min(tiles.size(), count));
    return tiles;
}

}  // namespace aoscore
