#include "reference/estimate/variance_fall.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace aoscore {
namespace {

/// Of the steps from 1, 2, 4 … points, against the usual fall; from the last on all are alike. Least squares
/// of log V(2n) / V(n) over pictures and steps, from 2 to 2,048 points; the first step was not measured.
constexpr std::array kSteps = {0.96, 0.96, 0.99, 0.98, 1.04, 0.99, 1.0, 0.96, 0.98, 0.97, 0.945};

double step(int size) {
    const auto number = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(size)));
    return kSteps[std::min(number, kSteps.size() - 1)];
}

}  // namespace

double variance_fall(double ratio, int size) {
    return ratio * step(size);
}

double variance_after_falls(double ratio, int size) {
    double variance = 1;
    for (int n = 1; n < size; n *= 2) variance *= variance_fall(ratio, n);
    return variance;
}

}  // namespace aoscore
