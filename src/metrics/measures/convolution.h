#pragma once

#include <cstddef>
#include <functional>
#include <span>

// The code is built twice, with wider registers where the machine has them, and with the same rounding in the
// same order.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AOSCORE_WIDER_WHERE_POSSIBLE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define AOSCORE_WIDER_WHERE_POSSIBLE
#endif

namespace aoscore {

/// sums[i] = the sum of from[k][i], each times its weight, for i in [0, count). `from` holds 2 n + 1
/// pointers, of which the middle one has the weight half[0], and those at distance k half[k]; for odd_sums
/// those before the middle have -half[k], and the middle has none. Rounding is the same on every machine.
void even_sums(double* sums, std::span<const double* const> from, std::span<const double> half,
               std::size_t count);
void odd_sums(double* sums, std::span<const double* const> from, std::span<const double> half,
              std::size_t count);

/// Calls body(band, first_row, rows) for fixed bands of rows on all cores; returns how many bands there are
/// for a height, so that sums of bands can be kept and added in order.
std::size_t band_count(int height);
void for_each_band(int height, const std::function<void(std::size_t band, int first_row, int rows)>& body);

}  // namespace aoscore
