#include "metrics/intervals/truth_noise.h"

#include "metrics/intervals/block_sums.h"
#include "metrics/intervals/extrapolation.h"
#include "metrics/measures.h"
#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace aoscore {
namespace {

constexpr double kDeviations = 1.96;  // these hold 95 % of a normal distribution
/// An image's sums, and the change of each block's by half the difference of the halves.
struct Moved {
    DrawnSums whole;
    std::vector<DrawnSums> by_block;
};

DrawnSums all_of(const std::vector<DrawnSums>& blocks) {
    DrawnSums all = blocks.front();
    for (std::size_t b = 1; b < blocks.size(); ++b) all += blocks[b];
    return all;
}

DrawnSums half_difference(const DrawnSums& first, const DrawnSums& second) {
    DrawnSums half;
    half.squared = (first.squared - second.squared) / 2;
    half.absolute = (first.absolute - second.absolute) / 2;
    half.difference = (first.difference - second.difference) / 2;
    half.ssim = (first.ssim - second.ssim) / 2;
    half.flip = (first.flip - second.flip) / 2;
    return half;
}

Moved moved(const BlockErrors& whole, const BlockErrors& first, const BlockErrors& second) {
    const std::vector<DrawnSums> a = sums_of_blocks(first), b = sums_of_blocks(second);
    Moved result{all_of(sums_of_blocks(whole)), {}};
    for (std::size_t i = 0; i < a.size(); ++i) result.by_block.push_back(half_difference(a[i], b[i]));
    return result;
}

/// The change of the metric by each block.
std::vector<double> movements(const Metric& metric, const Moved& moved) {
    const double still = metric.resampled(moved.whole);
    std::vector<double> by_block;
    for (const DrawnSums& block : moved.by_block) {
        DrawnSums sums = moved.whole;
        sums += block;
        by_block.push_back(metric.resampled(sums) - still);
    }
    return by_block;
}

/// The variance of the sum, where adjacent blocks may be correlated.
double variance_of_sum(const std::vector<double>& moves, int across, int down) {
    double alone = 0, together = 0;
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < across; ++x) {
            const double move = moves[static_cast<std::size_t>(y * across + x)];
            alone += move * move;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, down - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, across - 1); ++u)
                    together += move * moves[static_cast<std::size_t>(v * across + u)];
            }
        }
    }
    return std::max(alone, together);
}

DrawnSums all_with_ms_ssim(const BlockErrors& image) {
    DrawnSums all = all_of(sums_of_blocks(image));
    if (image.maps.ms_ssim) all.ms_ssim = *image.maps.ms_ssim;
    return all;
}

/// The sums, with those of SSIM against the truth as it is; NaN where they are not there.
DrawnSums with_noise(DrawnSums all, const MapSums* noisy) {
    all.ssim = std::numeric_limits<double>::quiet_NaN();
    if (noisy != nullptr && !noisy->ssim_sums.empty())
        all.ssim = std::accumulate(noisy->ssim_sums.begin(), noisy->ssim_sums.end(), 0.0);
    return all;
}

/// The standard deviation over scenes of what an extrapolation leaves of the noise, which no other seed would
/// change.
double left_over(const Metric& metric, const DrawnSums& whole, const DrawnSums& extrapolated,
                 const DrawnSums& noisy, int samples) {
    if (metric.noise != Metric::Noise::extrapolated) return 0;
    const double variance = whole.variance / whole.count, value = metric.resampled(extrapolated);
    const double left = metric.part_left(variance) * std::abs(value - metric.resampled(whole));
    if (metric.left_by_noise == 0) return left;
    return std::hypot(left, metric.part_of_noise_left(samples) * std::abs(value - metric.resampled(noisy)));
}

double ms_ssim_variance(const MapSums& whole, const MapSums& first, const MapSums& second) {
    double variance = 0;
    for (std::size_t k = 0; k < whole.ms_ssim_influences.size(); ++k) {
        const double move = *whole.ms_ssim * (first.ms_ssim_influences[k] - second.ms_ssim_influences[k]) / 2;
        variance += move * move;
    }
    return variance;
}

}  // namespace

std::map<std::string, double> truth_noise(const BlockErrors& whole, const BlockErrors& first,
                                          const BlockErrors& second, const TruthHalves& halves) {
    const Moved sums = moved(whole, first, second);
    const DrawnSums all = all_with_ms_ssim(whole);
    const DrawnSums all_extrapolated = all_with_ms_ssim(extrapolated(whole, first, second));
    const DrawnSums all_noisy = with_noise(all, halves.noisy_maps);
    const bool has_ms_ssim = whole.maps.ms_ssim && first.maps.ms_ssim && second.maps.ms_ssim;
    std::map<std::string, double> noise;
    for (const Metric& metric : metrics()) {
        if (metric.noise == Metric::Noise::included || metric.resampled == nullptr) continue;
        const double variance = metric.measure == measure::ms_ssim && has_ms_ssim
                                    ? ms_ssim_variance(whole.maps, first.maps, second.maps)
                                    : variance_of_sum(movements(metric, sums), whole.across, whole.down);
        const double left = left_over(metric, all, all_extrapolated, all_noisy, halves.samples);
        const double half_width = kDeviations * std::hypot(std::sqrt(variance), left);
        if (std::isfinite(half_width)) noise[std::string(metric.id)] = half_width;
    }
    return noise;
}

}  // namespace aoscore
