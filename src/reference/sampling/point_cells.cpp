#include "reference/sampling/point_cells.h"

#include "reference/sampling/z_order.h"

#include <bit>

namespace aoscore {
namespace {

std::uint32_t top_bits(std::uint32_t x, unsigned bits) {
    return bits == 0 ? 0 : x >> (32 - bits);
}

}  // namespace

int net_after(int first, int last) {
    const auto most = std::bit_floor(static_cast<unsigned>(last - first));
    const auto aligned = first == 0 ? most : static_cast<unsigned>(first) & -static_cast<unsigned>(first);
    return static_cast<int>(most < aligned ? most : aligned);
}

PointCells::PointCells(const PointSets& points, int first, int size)
    : first_(first),
      size_(size),
      u_bits_((static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(size))) + 1) / 2),
      v_bits_(static_cast<unsigned>(std::countr_zero(static_cast<unsigned>(size))) - u_bits_) {
    const auto count = static_cast<std::size_t>(size);
    points_.resize(PointSets::kSets * count);
    for (std::size_t set = 0; set < PointSets::kSets; ++set) {
        const PointSets::Coordinates from = points.set(set);
        for (int i = first; i < first + size; ++i) {
            const std::size_t place = set * count + cell(from.u[i], from.v[i]);
            points_[place] = point_word(from.u[i], from.v[i], static_cast<std::uint32_t>(i - first));
        }
    }
}

std::uint32_t PointCells::cell(std::uint32_t u, std::uint32_t v) const {
    return z_order(top_bits(u, u_bits_), top_bits(v, v_bits_));
}

}  // namespace aoscore
