#pragma once

#include "reference/sampling/point_sets.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aoscore {

/// The largest power of two of points, from number `first` of a sequence on and before number `last`, that
/// form a net by themselves: `first` is a multiple of it. `last` must be greater than `first`.
int net_after(int first, int last);

/// The points [first, first + size) of all of some point sets, `size` a power of two and `first` a multiple
/// of it, by the cells of the unit square in which they lie: squares or, where `size` is an odd power of two,
/// rectangles twice as high as wide, of which each has one point (Owen, Randomly Permuted (t,m,s)-Nets and
/// (t,s)-Sequences, 1995). Cells are counted along a Z-order curve, so that a digital shift of the points
/// moves cell c to cell c ^ shifted_cell().
class PointCells {
  public:
    PointCells(const PointSets& points, int first, int size);

    int first() const { return first_; }
    int size() const { return size_; }
    /// Of set number k the points are those from k * size() on.
    const std::uint32_t* u() const { return u_.data(); }  ///< fractions of 2^32
    const std::uint32_t* v() const { return v_.data(); }
    const std::uint32_t* number() const { return number_.data(); }  ///< of a point in its set
    /// The cell in which a point of these coordinates lies: the cell by which a shift by them moves all.
    std::uint32_t cell(std::uint32_t u, std::uint32_t v) const;

  private:
    int first_, size_;
    unsigned u_bits_, v_bits_;
    std::vector<std::uint32_t> u_, v_, number_;
};

}  // namespace aoscore
