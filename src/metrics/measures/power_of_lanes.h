#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

// A power in additions, multiplications and a division alone, so that loops over it take several values at
// once and give the same bits on every machine. It is inlined into loops that are built for wide registers
// (see wide_lanes.h); raise() in power.h is such a loop.
namespace aoscore {
namespace lanes {

inline constexpr int kMantissaBits = 52;
inline constexpr std::uint64_t kExponentBias = 1024;
inline constexpr double kLeast =
    0x1p-330;  ///< smaller values are 0; its third power is still a normal number

// The polynomials below interpolate their functions at Chebyshev's nodes; the coefficients were computed with
// sixty digits.

/// The logarithm of a positive normal number: its exponent, plus the logarithm of the rest, m in [sqrt(1/2),
/// sqrt(2)), which is 2 artanh(s) / ln 2 with s = (m - 1) / (m + 1): s times a polynomial of s^2, whose
/// relative error is below 2e-16.
[[gnu::always_inline]] inline double log2_of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto least = std::bit_cast<std::uint64_t>(0.5 * std::numbers::sqrt2);
    const std::uint64_t exponent = (bits - least + (kExponentBias << kMantissaBits)) >> kMantissaBits;
    const double m = std::bit_cast<double>(bits - ((exponent - kExponentBias) << kMantissaBits));
    // With an integer in its mantissa, 2^52 becomes 2^52 plus that integer.
    const double whole = std::bit_cast<double>(exponent | std::bit_cast<std::uint64_t>(0x1p52)) -
                         (0x1p52 + double{kExponentBias});
    const double s = (m - 1) / (m + 1), z = s * s;
    double sum = 0.2429160853987535;
    sum = sum * z + 0.2614442493522915;
    sum = sum * z + 0.32061638813224547;
    sum = sum * z + 0.4121984020482752;
    sum = sum * z + 0.5770780172463286;
    sum = sum * z + 0.9617966939243345;
    sum = sum * z + 2.885390081777927;
    return whole + s * sum;
}

/// 2 to the power of a number in [-1000, 1000]: its nearest integer goes to the exponent, and the rest r into
/// 1 + r times a polynomial, whose relative error is below 6e-16.
[[gnu::always_inline]] inline double exp2_of(double x) {
    const double shifted = x + 0x1.8p52;  // its last bits are the nearest integer
    const double rest = x - (shifted - 0x1.8p52);
    double sum = 7.070977866508138e-09;
    sum = sum * rest + 1.0205905413765595e-07;
    sum = sum * rest + 1.3215451633221434e-06;
    sum = sum * rest + 1.5252672924850737e-05;
    sum = sum * rest + 0.00015403530424776529;
    sum = sum * rest + 0.0013333558200794592;
    sum = sum * rest + 0.009618129107618665;
    sum = sum * rest + 0.05550410866465167;
    sum = sum * rest + 0.24022650695910075;
    sum = sum * rest + 0.6931471805599462;
    sum = sum * rest + 1;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) +
                                 (std::bit_cast<std::uint64_t>(shifted) << kMantissaBits));
}

/// 1 where a number that is not negative is less than the limit, else 0; a comparison would keep the compiler
/// from taking several values at once.
[[gnu::always_inline]] inline std::uint64_t is_less(double x, double limit) {
    return (std::bit_cast<std::uint64_t>(x) - std::bit_cast<std::uint64_t>(limit)) >> 63;
}

/// base^exponent as raise() of power.h has it.
[[gnu::always_inline]] inline double power(double base, double exponent) {
    const auto raised = std::bit_cast<std::uint64_t>(exp2_of(exponent * log2_of(base)));
    const std::uint64_t of_zero = is_less(exponent, kLeast) * std::bit_cast<std::uint64_t>(1.0);
    const std::uint64_t is_zero = is_less(base, kLeast);
    return std::bit_cast<double>(((is_zero - 1) & raised) | (-is_zero & of_zero));
}

}  // namespace lanes

using lanes::power;

}  // namespace aoscore
