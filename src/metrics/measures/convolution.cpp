#include "metrics/measures/convolution.h"

#include "core/threads.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

namespace aoscore {
namespace {

// High enough that the rows read twice by neighbours cost little, low enough for a band's planes to stay in
// cache.
constexpr int kBandRows = 64;

// Several doubles side by side. Written out, because GCC 12 would rather look for them among the taps.
constexpr std::size_t kLanes = 4;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void weighted_sums(double* sums, std::span<const double* const> from, std::span<const double> kernel,
                   std::size_t count) {
    constexpr std::size_t kBlock = 4 * kLanes;  // As many sums as stay in registers.
    std::size_t i = 0;
    for (; i + kBlock <= count; i += kBlock) {
        Lanes a{}, b{}, c{}, d{};
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const double weight = kernel[k];
            const double* values = from[k] + i;
            Lanes v;
            std::memcpy(&v, values, sizeof v);
            a += weight * v;
            std::memcpy(&v, values + kLanes, sizeof v);
            b += weight * v;
            std::memcpy(&v, values + 2 * kLanes, sizeof v);
            c += weight * v;
            std::memcpy(&v, values + 3 * kLanes, sizeof v);
            d += weight * v;
        }
        std::memcpy(sums + i, &a, sizeof a);
        std::memcpy(sums + i + kLanes, &b, sizeof b);
        std::memcpy(sums + i + 2 * kLanes, &c, sizeof c);
        std::memcpy(sums + i + 3 * kLanes, &d, sizeof d);
    }
    for (; i < count; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * from[k][i];
        sums[i] = sum;
    }
}

Plane convolve_inside(const Plane& plane, std::span<const double> across, std::span<const double> down) {
    const int width = plane.width - static_cast<int>(across.size()) + 1;
    const int height = plane.height - static_cast<int>(down.size()) + 1;
    assert(width > 0 && height > 0);
    const auto columns = static_cast<std::size_t>(width);
    std::vector<const double*> from;
    Plane rows(width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
        from.clear();
        for (std::size_t k = 0; k < across.size(); ++k) from.push_back(&plane.at(0, y) + k);
        weighted_sums(&rows.at(0, y), from, across, columns);
    }
    Plane result(width, height);
    for (int y = 0; y < height; ++y) {
        from.clear();
        for (std::size_t k = 0; k < down.size(); ++k) from.push_back(&rows.at(0, y + static_cast<int>(k)));
        weighted_sums(&result.at(0, y), from, down, columns);
    }
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
