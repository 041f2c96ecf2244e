#include "metrics/analysis/mask_totals.h"

#include "core/threads.h"
#include "metrics/analysis/beyond_threshold.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aoscore {
namespace {

using Causes = std::vector<PixelFacts::Cause>;

/// Marks the pixels of a row that may have a part beyond the threshold.
AOSCORE_WIDER_WHERE_POSSIBLE
void mark_near(const float* truth, const float* test, const float* standard_error, const std::uint8_t* valid,
               double threshold, std::uint8_t* near, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const double error = std::abs(double{test[i]} - double{truth[i]});
        const bool beyond = error + boxes::kWideReach * double{standard_error[i]} > threshold;
        near[i] = static_cast<std::uint8_t>(beyond & (valid[i] != 0));
    }
}

void add_causes(const BeyondThreshold& beyond, const Causes& causes, std::size_t i, MaskTotal& total) {
    double occlusion = 0;
    for (const PixelFacts::Cause& cause : causes) occlusion += double{cause.occlusion->pixels[i]};
    if (occlusion <= 0) return;
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const double part = double{causes[c].occlusion->pixels[i]} / occlusion;
        total.by_cause[c].add(part * beyond.share, part * beyond.error);
    }
}

void add_pixel(const BeyondThreshold& beyond, double noise, std::size_t block, MaskTotal& total) {
    total.whole.add(beyond.share, beyond.error);
    total.doubt += beyond.doubt;
    total.doubtful_noise += beyond.doubt * noise;
    total.variance += beyond.share * noise * noise;
    total.share_blocks[block] += beyond.share;
    total.error_blocks[block] += beyond.error;
}

/// One row of blocks at a time.
class Rows {
  public:
    Rows(const MetricInput& input, double threshold, const Causes& causes)
        : input_(input),
          threshold_(threshold),
          causes_(causes),
          near_(static_cast<std::size_t>(input.valid.width)),
          sure_(input.standard_error == nullptr ? near_.size() : 0) {}

    void add(int y, const BlockGrid& grid, MaskTotals& totals) {
        const std::uint8_t* valid = &input_.valid.at(0, y);
        mark_near(&input_.truth.at(0, y), &input_.test.at(0, y),
                  sure_.empty() ? &input_.standard_error->at(0, y) : sure_.data(), valid, threshold_,
                  near_.data(), near_.size());
        totals.valid += static_cast<double>(near_.size()) -
                        static_cast<double>(std::count(valid, valid + near_.size(), std::uint8_t{0}));
        const std::size_t row = input_.valid.index(0, y);
        grid.for_each_piece(y, 0, input_.valid.width, 0, [&](std::size_t block, int from, int to) {
            for (auto x = static_cast<std::size_t>(from); x < static_cast<std::size_t>(to); ++x) {
                if (near_[x] != 0) add_near(row + x, block % static_cast<std::size_t>(grid.across), totals);
            }
        });
    }

  private:
    void add_near(std::size_t i, std::size_t block, MaskTotals& totals) const {
        const double noise = sure_.empty() ? double{input_.standard_error->pixels[i]} : 0.0;
        const BeyondThreshold missing = beyond_threshold(input_, i, MaskSide::missing, threshold_);
        add_pixel(missing, noise, block, totals.missing);
        add_causes(missing, causes_, i, totals.missing);
        add_pixel(beyond_threshold(input_, i, MaskSide::false_occlusion, threshold_), noise, block,
                  totals.false_occlusion);
    }

    const MetricInput& input_;
    double threshold_;
    const Causes& causes_;
    std::vector<std::uint8_t> near_;
    std::vector<float> sure_;  ///< zeros, in place of a standard error that is not known
};

void append(const MaskTotal& row, MaskTotal& all) {
    all.whole.add(row.whole.share, row.whole.error);
    all.doubt += row.doubt;
    all.doubtful_noise += row.doubtful_noise;
    all.variance += row.variance;
    for (std::size_t c = 0; c < all.by_cause.size(); ++c)
        all.by_cause[c].add(row.by_cause[c].share, row.by_cause[c].error);
    all.share_blocks.insert(all.share_blocks.end(), row.share_blocks.begin(), row.share_blocks.end());
    all.error_blocks.insert(all.error_blocks.end(), row.error_blocks.begin(), row.error_blocks.end());
}

}  // namespace

MaskTotals mask_totals(const MetricInput& input, double threshold, const Causes& causes) {
    require_one_size(input);
    // Noise that pushes pixels over a threshold is known by those that it keeps below: none is below 0.
    MetricInput counted = input;
    if (threshold <= 0) counted.standard_error = nullptr;
    const BlockGrid grid(input.valid.width, input.valid.height);
    MaskTotals empty;
    empty.missing.by_cause.resize(causes.size());
    MaskTotals one_row = empty;
    for (MaskTotal* total : {&one_row.missing, &one_row.false_occlusion}) {
        total->share_blocks.resize(static_cast<std::size_t>(grid.across));
        total->error_blocks.resize(total->share_blocks.size());
    }
    std::vector<MaskTotals> block_rows(static_cast<std::size_t>(grid.down), one_row);
    parallel_for(block_rows.size(), [&](std::size_t block_row) {
        Rows rows(counted, threshold, causes);
        const int top = static_cast<int>(block_row) * grid.side_px;
        for (int y = top; y < std::min(top + grid.side_px, input.valid.height); ++y)
            rows.add(y, grid, block_rows[block_row]);
    });
    MaskTotals all = empty;
    for (const MaskTotals& row : block_rows) {
        all.valid += row.valid;
        append(row.missing, all.missing);
        append(row.false_occlusion, all.false_occlusion);
    }
    return all;
}

}  // namespace aoscore
