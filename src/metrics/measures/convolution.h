#pragma once

#include "core/image.h"

#include <cstddef>
#include <functional>
#include <span>

// Built twice, with wider registers where the machine has them: the same roundings in the same order.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define AOSCORE_WIDER_WHERE_POSSIBLE __attribute__((target_clones("avx2", "default")))
#else
#define AOSCORE_WIDER_WHERE_POSSIBLE
#endif

namespace aoscore {

using Plane = Image<double>;

/// The plane convolved with a separable kernel (`across` the columns, `down` the rows, both of odd length),
/// only where the kernel lies inside: smaller by a kernel's length less one. One thread; meant for bands.
/// Kernels are given as they lie over the image (correlation), which for symmetric and antisymmetric ones
/// differs in sign at most.
Plane convolve_inside(const Plane& plane, std::span<const double> across, std::span<const double> down);

/// sums[i] = sum over k of kernel[k] * from[k][i] for i in [0, count): the same roundings in the same order
/// on every machine. `from` has a pointer for each weight.
void weighted_sums(double* sums, std::span<const double* const> from, std::span<const double> kernel,
                   std::size_t count);

/// Calls body(band, first_row, rows) for fixed bands of rows on all cores; returns how many bands there are
/// for a height, so that sums of bands can be kept and added in order.
std::size_t band_count(int height);
void for_each_band(int height, const std::function<void(std::size_t band, int first_row, int rows)>& body);

}  // namespace aoscore
