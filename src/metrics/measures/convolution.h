#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace aoscore {

/// One of several filters of the same values. `half` holds the weight of the middle value and those of the
/// values at distance 1, 2, …; with an odd filter those before the middle have the negative weight, and the
/// middle has none. `sums` receives the results.
struct HalfFilter {
    double* sums;
    const double* half;
};

/// filter.sums[i] = the sum of from[k][i], each times its weight, for i in [0, count) and every filter.
/// `from` holds 2 n + 1 pointers, and a filter n + 1 weights. Rounding is the same on every machine.
void even_sums(std::span<const double* const> from, std::size_t count, HalfFilter even);
void odd_and_even_sums(std::span<const double* const> from, std::size_t count, HalfFilter odd,
                       HalfFilter even);
void odd_and_even_sums(std::span<const double* const> from, std::size_t count, HalfFilter odd,
                       const HalfFilter (&even)[3]);

/// Calls body(band, first_row, rows) for fixed bands of rows on all cores; returns how many bands there are
/// for a height, so that sums of bands can be kept and added in order.
std::size_t band_count(int height);
void for_each_band(int height, const std::function<void(std::size_t band, int first_row, int rows)>& body);

}  // namespace aoscore
