#include "metrics/block_errors.h"

#include "metrics/mean_error.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr int kBlocksAcross = 24;

}  // namespace

BlockErrors block_errors(const MetricInput& input) {
    require_one_size(input);
    BlockErrors blocks;
    blocks.side_px = std::max(1, input.truth.width / kBlocksAcross);
    blocks.across = (input.truth.width + blocks.side_px - 1) / blocks.side_px;
    blocks.down = (input.truth.height + blocks.side_px - 1) / blocks.side_px;
    blocks.counts.assign(static_cast<std::size_t>(blocks.across) * static_cast<std::size_t>(blocks.down), 0);
    blocks.squared_sums = blocks.absolute_sums = blocks.signed_sums = blocks.counts;
    if (input.standard_error != nullptr) blocks.variance_sums = blocks.counts;
    for (int y = 0; y < input.truth.height; ++y) {
        for (int x = 0; x < input.truth.width; ++x) {
            const std::size_t i = input.truth.index(x, y);
            if (input.valid.pixels[i] == 0) continue;
            const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
            const auto block =
                static_cast<std::size_t>(y / blocks.side_px * blocks.across + x / blocks.side_px);
            blocks.counts[block] += 1;
            blocks.squared_sums[block] += error * error;
            blocks.absolute_sums[block] += std::abs(error);
            blocks.signed_sums[block] += error;
            if (input.standard_error == nullptr) continue;
            const auto sigma = double{input.standard_error->pixels[i]};
            blocks.variance_sums[block] += sigma * sigma;
        }
    }
    return blocks;
}

}  // namespace aoscore
