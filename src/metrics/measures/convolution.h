#pragma once

#include "metrics/measures/wide_lanes.h"

#include <array>
#include <cstddef>

// Sums of neighbouring values, each times its weight, with filters that are even or odd, so that the two
// values at a distance need one multiplication. They are inlined into loops that are built for wide registers
// (see wide_lanes.h); rounding is the same on every machine.
namespace aoscore {

/// One of several filters of the same values. `half` holds the weight of the middle value and those of the
/// values at distance 1, 2, …; with an odd filter those before the middle have the negative weight, and the
/// middle has none. `sums` receives the results.
struct HalfFilter {
    double* sums;
    const double* half;
};

namespace lanes {

/// The sums of `kBlock` neighbouring Values, beginning with the value at `i`. They stay in registers, as all
/// inner loops are unrolled.
template <class Value, std::size_t kBlock, std::size_t kReach, std::size_t kOdd, std::size_t kEven, class Row>
[[gnu::always_inline]] inline void sums_at(std::size_t i, const Row& row, const HalfFilter* odd,
                                           const HalfFilter* even) {
    constexpr std::size_t kWidth = sizeof(Value) / sizeof(double);
    Value odd_sums[kOdd + 1][kBlock], even_sums[kEven][kBlock];
#pragma GCC unroll 4
    for (std::size_t b = 0; b < kBlock; ++b) {
        Value value;
        load(value, row(kReach) + i + b * kWidth);
#pragma GCC unroll 4
        for (std::size_t f = 0; f < kOdd; ++f) odd_sums[f][b] = Value{};
#pragma GCC unroll 4
        for (std::size_t f = 0; f < kEven; ++f) even_sums[f][b] = even[f].half[0] * value;
    }
    for (std::size_t k = 1; k <= kReach; ++k) {
        const double *after = row(kReach + k) + i, *before = row(kReach - k) + i;
#pragma GCC unroll 4
        for (std::size_t b = 0; b < kBlock; ++b) {
            Value one, other;
            load(one, after + b * kWidth);
            load(other, before + b * kWidth);
            const Value difference = one - other, sum = one + other;
#pragma GCC unroll 4
            for (std::size_t f = 0; f < kOdd; ++f) odd_sums[f][b] += odd[f].half[k] * difference;
#pragma GCC unroll 4
            for (std::size_t f = 0; f < kEven; ++f) even_sums[f][b] += even[f].half[k] * sum;
        }
    }
#pragma GCC unroll 4
    for (std::size_t b = 0; b < kBlock; ++b) {
#pragma GCC unroll 4
        for (std::size_t f = 0; f < kOdd; ++f) store(odd[f].sums + i + b * kWidth, odd_sums[f][b]);
#pragma GCC unroll 4
        for (std::size_t f = 0; f < kEven; ++f) store(even[f].sums + i + b * kWidth, even_sums[f][b]);
    }
}

template <std::size_t kBlock, std::size_t kReach, std::size_t kOdd, std::size_t kEven, class Row>
[[gnu::always_inline]] inline void all_sums(std::size_t count, const Row& row, const HalfFilter* odd,
                                            const HalfFilter* even) {
    std::size_t i = 0;
    for (; i + kBlock * kLanes <= count; i += kBlock * kLanes)
        sums_at<Lanes, kBlock, kReach, kOdd, kEven>(i, row, odd, even);
    for (; i < count; ++i) sums_at<double, 1, kReach, kOdd, kEven>(i, row, odd, even);
}

}  // namespace lanes
}  // namespace aoscore
