#pragma once

#include "metrics/intervals/block_errors.h"
#include "metrics/metric.h"

#include <cstddef>

namespace aoscore {

// Noise of the truth moves a smooth function of the picture by c times the noise's variance, and by terms of
// higher order. The mean of two independent halves has half the variance of either, so that
//     2 f(mean) - (f(first half) + f(second half)) / 2
// is free of the first term (Lewis Fry Richardson, The Approximate Arithmetical Solution by Finite
// Differences, 1911; for estimates from samples: Maurice Quenouille, Notes on Bias in Estimation, 1956).

/// The same comparison against one half of the truth, 0 or 1, without a standard error.
MetricInput against_half(const MetricInput& input, std::size_t half);

inline double extrapolated(double whole, double first, double second) {
    return 2 * whole - (first + second) / 2;
}
/// Extrapolates a value. It is empty where one of them is; the note is that of the whole.
MetricValue extrapolated(const MetricValue& whole, const MetricValue& first, const MetricValue& second);

/// Extrapolates the sums of metrics that are extrapolated; all others are those of the whole.
BlockErrors extrapolated(BlockErrors whole, const BlockErrors& first, const BlockErrors& second);

}  // namespace aoscore
