#include "reference/integrator/tile.h"

#include "core/sampling.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace aoscore {
namespace {

/// The place of a cell on the curve of Hilbert (Über die stetige Abbildung einer Linie auf ein Flächenstück,
/// 1891) through a square of `side` (a power of two) cells a side.
std::uint64_t on_curve(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
    std::uint64_t place = 0;
    for (std::uint32_t half = side / 2; half > 0; half /= 2) {
        const bool right = (x & half) != 0, low = (y & half) != 0;
        place += std::uint64_t{half} * half * ((right ? 3u : 0u) ^ (low ? 1u : 0u));
        if (low) continue;
        if (right) {
            x = side - 1 - x;
            y = side - 1 - y;
        }
        std::swap(x, y);
    }
    return place;
}

}  // namespace

std::vector<Tile> random_tiles(int width, int height, std::size_t count) {
    std::vector<Tile> tiles = tiles_of(width, height);
    const auto key = [](const Tile& tile) {
        return mix_bits(static_cast<std::uint64_t>(tile.y0) << 32 | static_cast<std::uint32_t>(tile.x0));
    };
    std::sort(tiles.begin(), tiles.end(), [&](const Tile& a, const Tile& b) { return key(a) < key(b); });
    tiles.resize(std::min(tiles.size(), count));
    return tiles;
}

std::vector<SpreadTile> spread_tiles(int width, int height) {
    constexpr std::uint32_t kScramble = 0x73707265;
    const std::uint32_t side =
        std::bit_ceil(static_cast<std::uint32_t>(std::max(width, height)) / kTileSide + 1);
    std::vector<std::pair<std::uint64_t, Tile>> along;
    for (const Tile& tile : tiles_of(width, height)) {
        const auto x = static_cast<std::uint32_t>(tile.x0 / kTileSide);
        const auto y = static_cast<std::uint32_t>(tile.y0 / kTileSide);
        along.emplace_back(on_curve(x, y, side), tile);
    }
    std::ranges::sort(along, {}, &std::pair<std::uint64_t, Tile>::first);
    // Tiles come in the order of van der Corput's points along the curve, with their bits scrambled: the
    // first 2^k are one out of each of 2^k equal stretches of it.
    const int bits = std::bit_width(along.size());
    std::vector<std::pair<std::uint32_t, SpreadTile>> ordered;
    for (std::size_t place = 0; place < along.size(); ++place) {
        const std::uint32_t reversed = reverse_bits(static_cast<std::uint32_t>(place) << (32 - bits));
        const std::uint32_t scrambled = owen_scramble_reversed(reversed, kScramble) >> (32 - bits);
        ordered.emplace_back(reverse_bits(scrambled), SpreadTile{along[place].second, place});
    }
    std::ranges::sort(ordered, {}, &std::pair<std::uint32_t, SpreadTile>::first);
    std::vector<SpreadTile> tiles;
    for (const auto& [order, tile] : ordered) tiles.push_back(tile);
    return tiles;
}

}  // namespace aoscore
