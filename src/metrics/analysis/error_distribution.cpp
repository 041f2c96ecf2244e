#include "metrics/analysis/error_distribution.h"

#include "metrics/analysis/error_curve.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures/bands.h"
#include "metrics/measures/mean_error.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

constexpr std::size_t kBins = 201, kSteps = 201;

/// The number of errors in each bin, and of those beyond each step.
struct Counts {
    explicit Counts(double step) : beyond(step, kSteps) {}

    std::vector<double> bins = std::vector<double>(kBins);
    ErrorCurve beyond;
    double pixels = 0;
};

/// The place of `position`, rounded down, or the first or last place where it lies beyond.
std::size_t place_below(double position, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(count - 1)));
}

void count_row(const MetricInput& input, const ErrorDistribution& scale, int y, Counts& counts) {
    const double bin_width = (scale.histogram_high - scale.histogram_low) / double{kBins};
    const std::size_t first = input.valid.index(0, y);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(input.valid.width); ++i) {
        if (input.valid.pixels[i] == 0) continue;
        const double test = double{input.test.pixels[i]}, error = test - double{input.truth.pixels[i]};
        const double noise = input.standard_error != nullptr ? double{input.standard_error->pixels[i]} : 0.0;
        ++counts.bins[place_below((error - scale.histogram_low) / bin_width, kBins)];
        counts.beyond.add(error, noise, test);
        counts.beyond.add(-error, noise, 1 - test);
        ++counts.pixels;
    }
}

}  // namespace

ErrorDistribution error_distribution(const MetricInput& input) {
    require_one_size(input);
    ErrorDistribution result;
    std::vector<Counts> bands(band_count(input.valid.height), Counts(result.cumulative_step));
    for_each_band(input.valid.height, [&](std::size_t band, int first_row, int rows) {
        for (int y = first_row; y < first_row + rows; ++y) count_row(input, result, y, bands[band]);
    });
    Counts all(result.cumulative_step);
    for (const Counts& band : bands) {
        add_sums(all.bins, band.bins);
        all.beyond.add(band.beyond);
        all.pixels += band.pixels;
    }
    const double count = std::max(all.pixels, 1.0);
    result.histogram = std::move(all.bins);
    for (double& bin : result.histogram) bin /= count;
    // With noise taken off, a curve may fall a little where it should not rise.
    double within = 0;
    for (const double beyond : all.beyond.sums()) {
        within = std::max(within, all.pixels > 0 ? std::min(1 - beyond / count, 1.0) : 0.0);
        result.cumulative.push_back(within);
    }
    return result;
}

}  // namespace aoscore
