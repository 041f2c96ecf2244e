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

/// One of two numbers; a branch would keep the compiler from taking several values at once.
[[gnu::always_inline]] inline double if_less(double x, double limit, double then, double otherwise) {
    const std::uint64_t mask = -is_less(x, limit);
    return std::bit_cast<double>((mask & std::bit_cast<std::uint64_t>(then)) |
                                 (~mask & std::bit_cast<std::uint64_t>(otherwise)));
}

/// 2^(exponent * log2), and 0 where `base`, on which the logarithm depends, is less than kLeast; 1 where the
/// exponent is, too.
[[gnu::always_inline]] inline double power_by_log2(double base, double log2, double exponent) {
    const auto raised = std::bit_cast<std::uint64_t>(exp2_of(exponent * log2));
    const std::uint64_t of_zero = is_less(exponent, kLeast) * std::bit_cast<std::uint64_t>(1.0);
    const std::uint64_t is_zero = is_less(base, kLeast);
    return std::bit_cast<double>(((is_zero - 1) & raised) | (-is_zero & of_zero));
}

/// base^exponent as raise() of power.h has it.
[[gnu::always_inline]] inline double power(double base, double exponent) {
    return power_by_log2(base, log2_of(base), exponent);
}

/// x to the power of -1/N of a positive normal number; no number for 0. The first guess, off by 4 % at most,
/// takes the upper half of a number's bits, exponent and mantissa, for its logarithm. Each of two steps
/// leaves the fourth power of the error: where e is 1 - x y^N, the root is y (1 - e)^(-1/N), whose series is
/// taken as far as e^3. The relative error is below 2e-15.
template <int N>
[[gnu::always_inline]] inline double inverse_root(double x) {
    static_assert(N == 3 || N == 5, "another root may need more steps");
    constexpr double kFirst = 1.0 / N, kSecond = kFirst * (1 + N) / (2 * N),
                     kThird = kSecond * (1 + 2 * N) / (3 * N);
    constexpr int kHalf = 32;
    constexpr double kOfOne = (1023 * (1 + 1.0 / N) - 1.0 / 16) * 0x1p20;
    // With an integer in its mantissa, 2^52 becomes 2^52 plus that integer.
    const double upper = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) >> kHalf |
                                               std::bit_cast<std::uint64_t>(0x1p52)) -
                         0x1p52;
    const double guess = kOfOne - upper * kFirst;
    const auto improved = [x](double y) {
        const double squared = y * y, raised = N == 3 ? squared * y : squared * squared * y;
        const double e = 1 - x * raised;
        return y + y * (e * (kFirst + e * (kSecond + e * kThird)));
    };
    const double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(guess + 0x1p52) << kHalf);
    return improved(improved(y));
}

/// The cube root of a number in (0, 1].
[[gnu::always_inline]] inline double cube_root(double x) {
    const double inverse = inverse_root<3>(x);
    return x * (inverse * inverse);
}

/// x to the power of 2.4, in (0, 1].
[[gnu::always_inline]] inline double to_the_2_4(double x) {
    const double root = x * inverse_root<5>(x);  // to the power of 0.8
    return root * root * root;
}

}  // namespace lanes

using lanes::cube_root;
using lanes::log2_of;
using lanes::power;
using lanes::power_by_log2;
using lanes::to_the_2_4;

}  // namespace aoscore
