#include "reference/estimate/pixel_spread.h"

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

static_assert(1 << kLevels == kBlocks);

/// Each level counts so many times what the one below counts for its freedom: less is extrapolated from it.
constexpr double kLevelWeight = 3;

double squared(double x) {
    return x * x;
}

}  // namespace

PixelSpread pixel_spread(std::span<const double> occlusion_sums, int samples) {
    double total = 0;
    for (const double sum : occlusion_sums) total += sum;
    PixelSpread pixel;
    pixel.samples = samples;
    pixel.visibility = std::clamp(1 - total / samples, 0.0, 1.0);
    const int size = block_size(samples);
    std::array<double, kBlocks> means{};
    int count = samples / size;  // whole blocks
    for (std::size_t b = 0; b < static_cast<std::size_t>(count); ++b) means[b] = occlusion_sums[b] / size;
    for (std::size_t l = 0; l < kLevels; ++l) {
        count /= 2;
        pixel.pairs[l] = count;
        double sum = 0;
        for (std::size_t pair = 0; pair < static_cast<std::size_t>(count); ++pair) {
            sum += squared((means[2 * pair] - means[2 * pair + 1]) / 2);
            means[pair] = (means[2 * pair] + means[2 * pair + 1]) / 2;
        }
        if (count > 0) pixel.differences[l] = sum / count;
    }
    return pixel;
}

double block_variance(const PixelSpread& pixel, double ratio) {
    double sum = 0, weights = 0, fall = 1 - ratio, weight = 1;
    for (std::size_t l = 0; l < kLevels; ++l, fall *= ratio, weight *= kLevelWeight) {
        sum += weight * pixel.pairs[l] * pixel.differences[l] / fall;
        weights += weight * pixel.pairs[l];
    }
    return weights > 0 ? sum / weights : 0;
}

double pooled_variance(int samples, double ratio) {
    const int size = block_size(samples);
    const int whole = samples / size;
    const double rest = static_cast<double>(samples % size) / size;  // of a block
    double sum = whole;
    // A part of a block varies more, by the same law.
    if (rest > 0) sum += squared(rest) * std::pow(rest, std::log2(ratio));
    const int blocks = whole + (rest > 0 ? 1 : 0);
    for (int i = 0; i < blocks; ++i) {
        for (int j = 0; j < i; ++j) {
            double covariance = 2 * ratio - 1;
            for (int shared = 1; (i >> shared) != (j >> shared); ++shared) covariance *= ratio;
            sum += 2 * covariance * (i < whole ? 1 : rest);
        }
    }
    return sum / squared(whole + rest);
}

}  // namespace aoscore
