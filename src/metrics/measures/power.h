#pragma once

#include <span>

namespace aoscore {

/// Raises every value, which lies in [0, 1e9], to the exponent, in [0, 3]; less than 1e-99 counts as 0, and 0
/// to the power of 0 is 1. The relative error is below 1e-13. It is several times as fast as std::pow, and
/// gives the same bits on every machine, since it has only additions, multiplications and a division.
void raise(std::span<double> values, double exponent);

}  // namespace aoscore
