#include "page/document/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace aoscore {
namespace {

std::string with_true_minus(std::string text) {
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

}  // namespace

std::string fixed_text(std::optional<double> value, int decimals) {
    if (!value || !std::isfinite(*value)) return kNoNumber;
    std::string text = fmt::format("{:.{}f}", *value, decimals);
    if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
    return with_true_minus(std::move(text));
}

std::string short_text(double value) {
    return std::isfinite(value) ? with_true_minus(fmt::format("{:.6g}", value)) : kNoNumber;
}

std::string percent_text(std::optional<double> fraction, int decimals) {
    if (!fraction) return kNoNumber;
    return fixed_text(*fraction * 100, decimals);
}

std::string count_text(std::size_t count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u202f";
        text += digits[i];
    }
    return text;
}

int column_decimals(const std::vector<std::optional<double>>& column) {
    double largest = 0;
    for (const std::optional<double>& value : column) {
        if (value && std::isfinite(*value)) largest = std::max(largest, std::abs(*value));
    }
    return largest < 100 ? 2 : largest < 1000 ? 1 : 0;
}

std::optional<double> ratio(std::optional<double> numerator, std::optional<double> denominator) {
    if (!numerator || !denominator || *denominator == 0) return std::nullopt;
    return *numerator / *denominator;
}

}  // namespace aoscore
