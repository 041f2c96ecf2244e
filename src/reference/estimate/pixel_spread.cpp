#include "reference/estimate/pixel_spread.h"

#include "reference/estimate/squared.h"
#include "reference/estimate/variance_fall.h"
#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

static_assert(1 << kLevels == kBlocks);

/// Each level counts so many times what the one below counts for its freedom: less is extrapolated from it.
constexpr double kLevelWeight = 3;

}  // namespace

PixelSpread pixel_spread(std::span<const double> occlusion_sums, int samples, PlaceInTile place) {
    double total = 0;
    for (const double sum : occlusion_sums) total += sum;
    PixelSpread pixel;
    pixel.samples = samples;
    pixel.place = place;
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
    double sum = 0, weights = 0, of_block = 1, weight = 1;
    int size = block_size(pixel.samples);
    for (std::size_t l = 0; l < kLevels; ++l, size *= 2, weight *= kLevelWeight) {
        const double fall = variance_fall(ratio, size);
        sum += weight * pixel.pairs[l] * pixel.differences[l] / (of_block * (1 - fall));
        weights += weight * pixel.pairs[l];
        of_block *= fall;
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
            double variance = 1;  // of the runs that hold one of the two each
            int run = size;
            for (int shared = 1; (i >> shared) != (j >> shared); ++shared, run *= 2)
                variance *= variance_fall(ratio, run);
            sum += 2 * variance * (2 * variance_fall(ratio, run) - 1) * (i < whole ? 1 : rest);
        }
    }
    return sum / squared(whole + rest);
}

}  // namespace aoscore
