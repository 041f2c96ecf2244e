#include "metrics/analysis/error_distribution.h"

#include "metrics/intervals/block_grid.h"
#include "metrics/measures/bands.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

constexpr std::size_t kBins = 201, kSteps = 201;

/// The number of errors in each bin, and the number that each step holds first; the last step is beyond all.
struct Counts {
    std::vector<double> bins = std::vector<double>(kBins), steps = std::vector<double>(kSteps + 1);
    double pixels = 0;
};

/// The place of `position`, rounded down, or the first or last place where it lies beyond.
std::size_t place_below(double position, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(count - 1)));
}

std::size_t place_above(double position, std::size_t count) {
    const std::size_t below = place_below(position, count);
    return below + (below + 1 < count && static_cast<double>(below) < position ? 1 : 0);
}

void count_row(const MetricInput& input, const ErrorDistribution& scale, int y, Counts& counts) {
    const double bin_width = (scale.histogram_high - scale.histogram_low) / double{kBins};
    const std::size_t first = input.valid.index(0, y);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(input.valid.width); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        ++counts.bins[place_below((error - scale.histogram_low) / bin_width, kBins)];
        ++counts.steps[place_above(std::abs(error) / scale.cumulative_step, kSteps + 1)];
        ++counts.pixels;
    }
}

}  // namespace

ErrorDistribution error_distribution(const MetricInput& input) {
    require_one_size(input);
    ErrorDistribution result;
    std::vector<Counts> bands(band_count(input.valid.height));
    for_each_band(input.valid.height, [&](std::size_t band, int first_row, int rows) {
        for (int y = first_row; y < first_row + rows; ++y) count_row(input, result, y, bands[band]);
    });
    Counts all;
    for (const Counts& band : bands) {
        add_sums(all.bins, band.bins);
        add_sums(all.steps, band.steps);
        all.pixels += band.pixels;
    }
    const double count = std::max(all.pixels, 1.0);
    result.histogram = std::move(all.bins);
    for (double& bin : result.histogram) bin /= count;
    double within = 0;
    for (std::size_t step = 0; step < kSteps; ++step) {
        within += all.steps[step];
        result.cumulative.push_back(within / count);
    }
    return result;
}

}  // namespace aoscore
