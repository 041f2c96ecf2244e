#pragma once

#include <cstddef>
#include <cstring>

// The code is built several times, with wider registers where the machine has them, and with the same
// rounding in the same order.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AOSCORE_WIDER_WHERE_POSSIBLE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define AOSCORE_WIDER_WHERE_POSSIBLE
#endif

namespace aoscore {

/// The number of doubles that are computed side by side. They are written out, because a compiler may not
/// reorder a sum, and GCC 12 would vectorise over the taps of a filter.
inline constexpr std::size_t kLanes = 8;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

/// Loads a Lanes or a double.
template <class Value>
[[gnu::always_inline]] inline void load(Value& value, const double* from) {
    std::memcpy(&value, from, sizeof value);
}
template <class Value>
[[gnu::always_inline]] inline void store(double* to, const Value& value) {
    std::memcpy(to, &value, sizeof value);
}

/// The lanes added in order.
[[gnu::always_inline]] inline double sum_of(const Lanes& lanes) {
    double sum = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) sum += lanes[lane];
    return sum;
}

}  // namespace aoscore
