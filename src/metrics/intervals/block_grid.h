#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace aoscore {

/// The fewest blocks with a valid pixel, and the fewest squares, from which an interval is told: drawn from
/// fewer of independent normal errors, the middle 95 % hold a mean in less than 92 % of cases, as its
/// distance is t-distributed.
inline constexpr std::size_t kFewestBlocks = 15;

/// An image divided into squares, row by row: at least as many across as are asked for; the last ones are cut
/// off at its end.
struct BlockGrid {
    int side_px = 1;
    int across = 0, down = 0;

    BlockGrid(int width, int height, int wanted_across = 24)
        : side_px(std::max(1, width / std::max(1, wanted_across))),
          across((width + side_px - 1) / side_px),
          down((height + side_px - 1) / side_px) {}

    std::size_t size() const { return static_cast<std::size_t>(across) * static_cast<std::size_t>(down); }

    /// Calls add(block, from, to) for the pieces of row y between first_x and last_x that lie in one block
    /// each. The row may be one of the image halved some times: the blocks are those of the whole image.
    template <class Add>
    void for_each_piece(int y, int first_x, int last_x, int halvings, Add add) const {
        const int row = (y << halvings) / side_px * across;
        const int step = 1 << halvings;
        for (int x = first_x; x < last_x;) {
            const int column = x * step / side_px;
            const int next = std::min(last_x, ((column + 1) * side_px + step - 1) / step);
            add(static_cast<std::size_t>(row + column), x, next);
            x = next;
        }
    }
};

/// Adds term by term; `sums` grows to the size of `more`.
inline void add_sums(std::vector<double>& sums, const std::vector<double>& more) {
    sums.resize(std::max(sums.size(), more.size()));
    for (std::size_t i = 0; i < more.size(); ++i) sums[i] += more[i];
}

}  // namespace aoscore
