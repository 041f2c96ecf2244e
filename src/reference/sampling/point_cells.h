#pragma once

#include "reference/sampling/point_sets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aoscore {

/// The largest power of two of points, from number `first` of a sequence on and before number `last`, that
/// form a net by themselves: `first` is a multiple of it. `last` must be greater than `first`.
int net_after(int first, int last);

/// A point in one word: as much of its coordinates as unit_interval() keeps, and its number among the samples
/// of a pixel. The exclusive or with a word of number 0 shifts it digitally.
constexpr std::uint64_t point_word(std::uint32_t u, std::uint32_t v, std::uint32_t number) {
    return std::uint64_t{u >> 9} << 41 | std::uint64_t{v >> 9} << 18 | number;
}
/// What point_word() was made of, the coordinates in their upper 23 bits.
constexpr std::uint32_t word_u(std::uint64_t word) {
    return static_cast<std::uint32_t>(word >> 41) << 9;
}
constexpr std::uint32_t word_v(std::uint64_t word) {
    return static_cast<std::uint32_t>(word >> 18) << 9;
}
constexpr std::uint32_t word_number(std::uint64_t word) {
    return static_cast<std::uint32_t>(word) & 0x3ffffu;
}

/// The points [first, first + size) of all of some point sets, `size` a power of two and `first` a multiple
/// of it, by the cells of the unit square in which they lie: squares or, where `size` is an odd power of two,
/// rectangles twice as high as wide, of which each has one point (Owen, Randomly Permuted (t,m,s)-Nets and
/// (t,s)-Sequences, 1995). Cells are counted along a Z-order curve, so that a digital shift of the points
/// moves cell c to cell c ^ cell(shift).
class PointCells {
  public:
    PointCells(const PointSets& points, int first, int size);

    int first() const { return first_; }
    int size() const { return size_; }
    /// Set number k has those from k * size() on. One word holds all of a point, since to look it up is what
    /// a point costs most.
    const std::uint64_t* points() const { return points_.data(); }
    /// The cell in which a point of these coordinates lies: the cell by which a shift by them moves all.
    std::uint32_t cell(std::uint32_t u, std::uint32_t v) const;

  private:
    int first_, size_;
    unsigned u_bits_, v_bits_;
    std::vector<std::uint64_t> points_;
};

}  // namespace aoscore
