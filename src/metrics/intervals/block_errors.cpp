#include "metrics/intervals/block_errors.h"

#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <cmath>

namespace aoscore {

BlockErrors block_errors(const MetricInput& input, const OcclusionMasks& masks) {
    require_one_size(input);
    const BlockGrid grid(input.truth.width, input.truth.height);
    BlockErrors blocks;
    blocks.side_px = grid.side_px;
    blocks.across = grid.across;
    blocks.down = grid.down;
    blocks.counts.assign(grid.size(), 0);
    blocks.squared_sums = blocks.absolute_sums = blocks.signed_sums = blocks.counts;
    blocks.missing_counts = blocks.false_counts = blocks.counts;
    if (knows_noise(input)) blocks.variance_sums = blocks.counts;
    if (input.maps != nullptr) blocks.maps = *input.maps;
    const auto add = [&](std::size_t block, std::size_t i) {
        if (input.valid.pixels[i] == 0) return;
        const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        blocks.counts[block] += 1;
        blocks.squared_sums[block] += error * error;
        blocks.absolute_sums[block] += std::abs(error);
        blocks.signed_sums[block] += error;
        blocks.missing_counts[block] += masks.missing.pixels[i];
        blocks.false_counts[block] += masks.false_occlusion.pixels[i];
        if (knows_noise(input)) blocks.variance_sums[block] += noise_variance(input, i);
    };
    for (int y = 0; y < input.truth.height; ++y) {
        grid.for_each_piece(y, 0, input.truth.width, 0, [&](std::size_t block, int from, int to) {
            for (int x = from; x < to; ++x) add(block, input.truth.index(x, y));
        });
    }
    return blocks;
}

}  // namespace aoscore
