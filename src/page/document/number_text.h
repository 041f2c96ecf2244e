#pragma once

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// These functions write numbers for pages: with equal decimals down a column, a true minus sign, and a dash
/// where there is none. None of them ever returns "nan" or "inf".

inline constexpr const char* kNoNumber = "–";

/// The number with so many decimals; kNoNumber where empty or not finite. It is never "−0.00".
std::string fixed_text(std::optional<double> value, int decimals);
/// The number as short as six significant digits allow: 0.299, 16, 1e-04.
std::string short_text(double value);
/// The fraction in percent: 0.123 as "12.30".
std::string percent_text(std::optional<double> fraction, int decimals = 2);
/// The count with narrow no-break spaces: 2073600 as "2 073 600".
std::string count_text(std::size_t count);

/// The decimals that give the largest number of a column about four significant digits: 2 below 100, 1 below
/// 1000, else 0.
int column_decimals(const std::vector<std::optional<double>>& column);

/// numerator / denominator; empty when either is, or the denominator is 0.
std::optional<double> ratio(std::optional<double> numerator, std::optional<double> denominator);

}  // namespace aoscore
