#include "metrics/measures/convolution.h"

#include "core/threads.h"
#include "metrics/measures/wide_lanes.h"

#include <algorithm>
#include <cassert>

namespace aoscore {
namespace {

// The height of a band: large enough that rows read twice by neighbours cost little, small enough for its
// planes to stay in cache.
constexpr int kBandRows = 64;

/// The sums of `kBlock` neighbouring Values, beginning with the value at `i`. They stay in registers.
template <class Value, std::size_t kBlock, std::size_t kOdd, std::size_t kEven>
[[gnu::always_inline]] inline void sums_at(std::size_t i, const double* const* middle, std::size_t reach,
                                           const HalfFilter* odd, const HalfFilter* even) {
    constexpr std::size_t kWidth = sizeof(Value) / sizeof(double);
    Value odd_sums[kOdd + 1][kBlock]{}, even_sums[kEven][kBlock];
    for (std::size_t b = 0; b < kBlock; ++b) {
        Value value;
        load(value, middle[0] + i + b * kWidth);
        for (std::size_t f = 0; f < kEven; ++f) even_sums[f][b] = even[f].half[0] * value;
    }
    for (std::size_t k = 1; k <= reach; ++k) {
        for (std::size_t b = 0; b < kBlock; ++b) {
            Value after, before;
            load(after, middle[k] + i + b * kWidth);
            load(before, *(middle - k) + i + b * kWidth);
            for (std::size_t f = 0; f < kOdd; ++f) odd_sums[f][b] += odd[f].half[k] * (after - before);
            for (std::size_t f = 0; f < kEven; ++f) even_sums[f][b] += even[f].half[k] * (after + before);
        }
    }
    for (std::size_t b = 0; b < kBlock; ++b) {
        for (std::size_t f = 0; f < kOdd; ++f) store(odd[f].sums + i + b * kWidth, odd_sums[f][b]);
        for (std::size_t f = 0; f < kEven; ++f) store(even[f].sums + i + b * kWidth, even_sums[f][b]);
    }
}

template <std::size_t kBlock, std::size_t kOdd, std::size_t kEven>
[[gnu::always_inline]] inline void all_sums(std::span<const double* const> from, std::size_t count,
                                            const HalfFilter* odd, const HalfFilter* even) {
    assert(from.size() % 2 == 1);
    const std::size_t reach = from.size() / 2;
    const double* const* middle = &from[reach];
    std::size_t i = 0;
    for (; i + kBlock * kLanes <= count; i += kBlock * kLanes)
        sums_at<Lanes, kBlock, kOdd, kEven>(i, middle, reach, odd, even);
    for (; i < count; ++i) sums_at<double, 1, kOdd, kEven>(i, middle, reach, odd, even);
}

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void even_sums(std::span<const double* const> from, std::size_t count, HalfFilter even) {
    all_sums<4, 0, 1>(from, count, nullptr, &even);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void odd_and_even_sums(std::span<const double* const> from, std::size_t count, HalfFilter odd,
                       HalfFilter even) {
    all_sums<2, 1, 1>(from, count, &odd, &even);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void odd_and_even_sums(std::span<const double* const> from, std::size_t count, HalfFilter odd,
                       const HalfFilter (&even)[3]) {
    all_sums<2, 1, 3>(from, count, &odd, even);
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
