#include "metrics/intervals/block_errors.h"

#include "core/threads.h"
#include "metrics/analysis/mask_totals.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

namespace {

/// Adds the pixels of a row from `from` to `to`, which lie in one block. They are summed before they are
/// written, in the order of reading.
void add_piece(const MetricInput& input, std::size_t block, std::size_t from, std::size_t to,
               BlockErrors& blocks) {
    const bool noise = knows_noise(input);
    double count = blocks.counts[block], squared = blocks.squared_sums[block];
    double absolute = blocks.absolute_sums[block], signed_sum = blocks.signed_sums[block];
    double variance = noise ? blocks.variance_sums[block] : 0;
    for (std::size_t i = from; i < to; ++i) {
        if (input.valid.pixels[i] == 0) continue;
        const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        count += 1;
        squared += error * error;
        absolute += std::abs(error);
        signed_sum += error;
        if (noise) variance += noise_variance(input, i);
    }
    blocks.counts[block] = count;
    blocks.squared_sums[block] = squared;
    blocks.absolute_sums[block] = absolute;
    blocks.signed_sums[block] = signed_sum;
    if (noise) blocks.variance_sums[block] = variance;
}

}  // namespace

BlockErrors block_errors(const MetricInput& input) {
    require_one_size(input);
    const int width = input.truth.width, height = input.truth.height;
    const BlockGrid grid(width, height);
    BlockErrors blocks;
    blocks.side_px = grid.side_px;
    blocks.across = grid.across;
    blocks.down = grid.down;
    blocks.counts.assign(grid.size(), 0);
    blocks.squared_sums = blocks.absolute_sums = blocks.signed_sums = blocks.counts;
    if (knows_noise(input)) blocks.variance_sums = blocks.counts;
    if (input.maps != nullptr) blocks.maps = *input.maps;
    parallel_for(static_cast<std::size_t>(grid.down), [&](std::size_t block_row) {
        const int top = static_cast<int>(block_row) * grid.side_px;
        for (int y = top; y < std::min(top + grid.side_px, height); ++y) {
            const std::size_t row = input.truth.index(0, y);
            grid.for_each_piece(y, 0, width, 0, [&](std::size_t block, int from, int to) {
                add_piece(input, block, row + static_cast<std::size_t>(from),
                          row + static_cast<std::size_t>(to), blocks);
            });
        }
    });
    return blocks;
}

BlockErrors with_masks(BlockErrors blocks, const MaskTotals& masks) {
    blocks.missing_counts = masks.missing.share_blocks;
    blocks.false_counts = masks.false_occlusion.share_blocks;
    return blocks;
}

}  // namespace aoscore
