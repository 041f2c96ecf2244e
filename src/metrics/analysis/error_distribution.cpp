#include "metrics/analysis/error_distribution.h"

#include "metrics/analysis/error_curve.h"
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

/// What noise adds to the curve is little, so that of a large picture about so many pixels tell it well
/// enough.
constexpr std::size_t kTellingPixels = 1 << 16;

/// The number of errors in each bin, and the number that each step holds first; the last step is beyond all.
/// Of some pixels, the curves with and without the noise.
struct Counts {
    explicit Counts(double step) : noisy(step, kSteps), debiased(step, kSteps) {}

    std::vector<double> bins = std::vector<double>(kBins), steps = std::vector<double>(kSteps + 1);
    ErrorCurve noisy, debiased;
    double pixels = 0, told = 0;

    void add(const Counts& other) {
        add_sums(bins, other.bins);
        add_sums(steps, other.steps);
        noisy.add(other.noisy);
        debiased.add(other.debiased);
        pixels += other.pixels;
        told += other.told;
    }
};

/// The place of `position`, rounded down, or the first or last place where it lies beyond.
std::size_t place_below(double position, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(count - 1)));
}

std::size_t place_above(double position, std::size_t count) {
    const std::size_t below = place_below(position, count);
    return below + (below + 1 < count && static_cast<double>(below) < position ? 1 : 0);
}

/// The distance of the pixels that tell the noise; odd, so that they lie in all columns of most pictures.
std::size_t stride_of(const Mask& mask) {
    return (mask.size() / kTellingPixels) | 1;
}

void tell_noise(const MetricInput& input, std::size_t i, Counts& counts) {
    if (input.valid.pixels[i] == 0) return;
    const double test = double{input.test.pixels[i]}, error = test - double{input.truth.pixels[i]};
    const double noise = double{input.standard_error->pixels[i]};
    counts.noisy.add(std::abs(error), 0, 1);
    counts.debiased.add(error, noise, test);
    counts.debiased.add(-error, noise, 1 - test);
    ++counts.told;
}

void count_row(const MetricInput& input, const ErrorDistribution& scale, int y, Counts& counts) {
    const double bin_width = (scale.histogram_high - scale.histogram_low) / double{kBins};
    const std::size_t first = input.valid.index(0, y);
    const std::size_t end = first + static_cast<std::size_t>(input.valid.width);
    for (std::size_t i = first; i < end; ++i) {
        if (input.valid.pixels[i] == 0) continue;
        const double error = double{input.test.pixels[i]} - double{input.truth.pixels[i]};
        ++counts.bins[place_below((error - scale.histogram_low) / bin_width, kBins)];
        ++counts.steps[place_above(std::abs(error) / scale.cumulative_step, kSteps + 1)];
        ++counts.pixels;
    }
    if (input.standard_error == nullptr) return;
    const std::size_t stride = stride_of(input.valid);
    for (std::size_t i = (first + stride - 1) / stride * stride; i < end; i += stride)
        tell_noise(input, i, counts);
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
    for (const Counts& band : bands) all.add(band);
    const double count = std::max(all.pixels, 1.0), told = std::max(all.told, 1.0);
    result.histogram = std::move(all.bins);
    for (double& bin : result.histogram) bin /= count;
    const std::vector<double> noisy = all.noisy.sums(), debiased = all.debiased.sums();
    double reached = 0, within = 0;
    for (std::size_t step = 0; step < kSteps; ++step) {
        reached += all.steps[step];
        const double share = reached / count + (noisy[step] - debiased[step]) / told;
        within = std::max(within, std::min(share, 1.0));  // noise taken off may let it fall a little
        result.cumulative.push_back(within);
    }
    return result;
}

}  // namespace aoscore
