#include "metrics/analysis/bin_blocks.h"

#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"

namespace aoscore {

BinBlocks bin_blocks(const MetricInput& input, const PixelDivision& division, std::size_t bin) {
    require_one_size(input);
    const int width = input.valid.width, height = input.valid.height;
    const BlockGrid grid(width, height);
    BinBlocks blocks{std::vector<double>(grid.size()), std::vector<double>(grid.size())};
    for (int y = 0; y < height; ++y) {
        const std::size_t row = input.valid.index(0, y);
        grid.for_each_piece(y, 0, width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) {
                const std::size_t i = row + static_cast<std::size_t>(x);
                if (division.bin_of.pixels[i] != bin) continue;
                blocks.counts[block] += 1;
                blocks.signed_sums[block] += double{input.test.pixels[i]} - double{input.truth.pixels[i]};
            }
        });
    }
    return blocks;
}

}  // namespace aoscore
