#include "metrics/convolution.h"

#include "core/threads.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace aoscore {
namespace {

// High enough that the rows read twice by neighbours cost little, low enough for a band's planes to stay in
// cache.
constexpr int kBandRows = 32;

// The same roundings in the same order on every machine, only more of them at once where the machine can.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AOSCORE_WIDER_WHERE_POSSIBLE __attribute__((target_clones("avx2", "default")))
#else
#define AOSCORE_WIDER_WHERE_POSSIBLE
#endif

/// sums[i] = sum over k of kernel[k] * values[i + k * stride], for i in [0, count).
AOSCORE_WIDER_WHERE_POSSIBLE
void weighted_sums(double* sums, const double* values, std::size_t stride, std::span<const double> kernel,
                   std::size_t count) {
    constexpr std::size_t kBlock = 16;  // As many sums as stay in registers.
    std::size_t i = 0;
    for (; i + kBlock <= count; i += kBlock) {
        std::array<double, kBlock> block{};
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const double* from = values + i + k * stride;
            for (std::size_t j = 0; j < kBlock; ++j) block[j] += kernel[k] * from[j];
        }
        std::copy(block.begin(), block.end(), sums + i);
    }
    for (; i < count; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * values[i + k * stride];
        sums[i] = sum;
    }
}

}  // namespace

Plane convolve_inside(const Plane& plane, std::span<const double> across, std::span<const double> down) {
    const int width = plane.width - static_cast<int>(across.size()) + 1;
    const int height = plane.height - static_cast<int>(down.size()) + 1;
    assert(width > 0 && height > 0);
    const auto columns = static_cast<std::size_t>(width);
    Plane rows(width, plane.height);
    for (int y = 0; y < plane.height; ++y) weighted_sums(&rows.at(0, y), &plane.at(0, y), 1, across, columns);
    Plane result(width, height);
    for (int y = 0; y < height; ++y) weighted_sums(&result.at(0, y), &rows.at(0, y), columns, down, columns);
    return result;
}

std::size_t band_count(int height) {
    return static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
}

void for_each_band(int height, const std::function<void(std::size_t, int, int)>& body) {
    parallel_for(band_count(height), [&](std::size_t band) {
        const int first = static_cast<int>(band) * kBandRows;
        body(band, first, std::min(kBandRows, height - first));
    });
}

}  // namespace aoscore
