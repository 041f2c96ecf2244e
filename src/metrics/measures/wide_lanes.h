#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

// The code is built several times, with wider registers where the machine has them, and with the same
// rounding in the same order.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AOSCORE_WIDER_WHERE_POSSIBLE __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define AOSCORE_WIDER_WHERE_POSSIBLE
#endif

// What a loop writes overlaps nothing that it reads: with many rows, the compiler would not look for itself.
#if defined(__clang__)
#define AOSCORE_NO_ROW_OVERLAPS _Pragma("clang loop vectorize(assume_safety)")
#else
#define AOSCORE_NO_ROW_OVERLAPS _Pragma("GCC ivdep")
#endif

namespace aoscore {

/// The number of doubles that are computed side by side. They are written out, because a compiler may not
/// reorder a sum, and GCC 12 would vectorise over the taps of a filter. As many as one register of AVX2
/// holds: what is wider than a register, GCC 12 keeps in memory, which takes five times as long.
inline constexpr std::size_t kLanes = 4;
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));

/// Loads a Lanes or a double.
template <class Value>
[[gnu::always_inline]] inline void load(Value& value, const double* from) {
    std::memcpy(&value, from, sizeof value);
}
/// Loads floats.
[[gnu::always_inline]] inline void load(Lanes& values, const float* from) {
    typedef float Floats __attribute__((vector_size(kLanes * sizeof(float))));
    Floats floats;
    std::memcpy(&floats, from, sizeof floats);
    values = __builtin_convertvector(floats, Lanes);
}
[[gnu::always_inline]] inline void load(double& value, const float* from) {
    value = double{*from};
}
template <class Value>
[[gnu::always_inline]] inline void store(double* to, const Value& value) {
    std::memcpy(to, &value, sizeof value);
}

/// Gives the lanes of pixels that do not count, which may be NaN, another value.
[[gnu::always_inline]] inline void replace_invalid(Lanes& values, const std::uint8_t* valid,
                                                   double other = 0) {
    typedef std::uint8_t Bytes __attribute__((vector_size(kLanes)));
    typedef std::int64_t Longs __attribute__((vector_size(kLanes * sizeof(std::int64_t))));
    Bytes bytes;
    std::memcpy(&bytes, valid, sizeof bytes);
    values = __builtin_convertvector(bytes, Longs) != 0 ? values : Lanes{} + other;
}
[[gnu::always_inline]] inline void replace_invalid(double& value, const std::uint8_t* valid,
                                                   double other = 0) {
    if (*valid == 0) value = other;
}

/// The lanes added in order.
[[gnu::always_inline]] inline double sum_of(const Lanes& lanes) {
    double sum = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) sum += lanes[lane];
    return sum;
}

/// Leaves their sizes alone.
[[gnu::always_inline]] inline void take_sign_off(Lanes& lanes) {
    lanes = lanes < 0 ? -lanes : lanes;
}

}  // namespace aoscore
