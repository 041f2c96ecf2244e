#pragma once

#include <cstdint>

namespace aoscore {

/// The place of row and column, each below 256, along a Z-order curve.
constexpr std::uint32_t z_order(std::uint32_t column, std::uint32_t row) {
    const auto spread_bits = [](std::uint32_t x) {  // moves bit i to bit 2 i
        x = (x | (x << 4)) & 0x0f0fu;
        x = (x | (x << 2)) & 0x3333u;
        return (x | (x << 1)) & 0x5555u;
    };
    return spread_bits(column) | (spread_bits(row) << 1);
}

}  // namespace aoscore
