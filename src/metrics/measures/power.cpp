#include "metrics/measures/power.h"

#include "metrics/measures/wide_lanes.h"

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace aoscore {
namespace {

constexpr int kMantissaBits = 52;
constexpr std::uint64_t kExponentBias = 1024;
constexpr double kLeast = 0x1p-330;  ///< smaller values are 0; its third power is still a normal number

/// The logarithm of a positive normal number: its exponent, plus the logarithm of the rest, m in [sqrt(1/2),
/// sqrt(2)), by ln m = 2 artanh((m - 1) / (m + 1)). Terms beyond the last would add less than 1e-16.
[[gnu::always_inline]] inline double log2_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto least = std::bit_cast<std::uint64_t>(0.5 * std::numbers::sqrt2);
    const std::uint64_t exponent = (bits - least + (kExponentBias << kMantissaBits)) >> kMantissaBits;
    const double m = std::bit_cast<double>(bits - ((exponent - kExponentBias) << kMantissaBits));
    // With an integer in its mantissa, 2^52 becomes 2^52 plus that integer.
    const double whole = std::bit_cast<double>(exponent | std::bit_cast<std::uint64_t>(0x1p52)) -
                         (0x1p52 + double{kExponentBias});
    const double s = (m - 1) / (m + 1), z = s * s;
    double sum = 1.0 / 19;
    sum = sum * z + 1.0 / 17;
    sum = sum * z + 1.0 / 15;
    sum = sum * z + 1.0 / 13;
    sum = sum * z + 1.0 / 11;
    sum = sum * z + 1.0 / 9;
    sum = sum * z + 1.0 / 7;
    sum = sum * z + 1.0 / 5;
    sum = sum * z + 1.0 / 3;
    sum = sum * z + 1;
    return whole + 2 / std::numbers::ln2 * s * sum;
}

/// 2 to the power of a number in [-1000, 1000]: its nearest integer goes to the exponent, the rest into the
/// series of e^x. Terms beyond the last would add less than 1e-16.
[[gnu::always_inline]] inline double exp2_of(double x) {
    const double shifted = x + 0x1.8p52;  // its last bits are the nearest integer
    const double rest = (x - (shifted - 0x1.8p52)) * std::numbers::ln2;
    double sum = 1.0 / 6227020800;
    sum = sum * rest + 1.0 / 479001600;
    sum = sum * rest + 1.0 / 39916800;
    sum = sum * rest + 1.0 / 3628800;
    sum = sum * rest + 1.0 / 362880;
    sum = sum * rest + 1.0 / 40320;
    sum = sum * rest + 1.0 / 5040;
    sum = sum * rest + 1.0 / 720;
    sum = sum * rest + 1.0 / 120;
    sum = sum * rest + 1.0 / 24;
    sum = sum * rest + 1.0 / 6;
    sum = sum * rest + 0.5;
    sum = sum * rest + 1;
    sum = sum * rest + 1;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) +
                                 (std::bit_cast<std::uint64_t>(shifted) << kMantissaBits));
}

/// 1 where a number that is not negative is less than the limit, else 0; a comparison would keep the compiler
/// from taking several values at once.
[[gnu::always_inline]] inline std::uint64_t is_less(double x, double limit) {
    return (std::bit_cast<std::uint64_t>(x) - std::bit_cast<std::uint64_t>(limit)) >> 63;
}

[[gnu::always_inline]] inline double power(double base, double exponent) {
    const auto raised = std::bit_cast<std::uint64_t>(exp2_of(exponent * log2_of(base)));
    const std::uint64_t of_zero = is_less(exponent, kLeast) * std::bit_cast<std::uint64_t>(1.0);
    const std::uint64_t is_zero = is_less(base, kLeast);
    return std::bit_cast<double>(((is_zero - 1) & raised) | (-is_zero & of_zero));
}

}  // namespace

AOSCORE_WIDER_WHERE_POSSIBLE
void raise(std::span<double> values, double exponent) {
    double* value = values.data();
    for (std::size_t i = 0; i < values.size(); ++i) value[i] = power(value[i], exponent);
}

AOSCORE_WIDER_WHERE_POSSIBLE
void raise(std::span<double> values, std::span<const double> exponents) {
    assert(values.size() == exponents.size());
    double* value = values.data();
    const double* exponent = exponents.data();
    for (std::size_t i = 0; i < values.size(); ++i) value[i] = power(value[i], exponent[i]);
}

}  // namespace aoscore
