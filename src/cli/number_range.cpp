#include "cli/number_range.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <limits>
#include <string>

namespace aoscore {
namespace {

CLI::Validator number_where(const std::function<bool(double)>& is_valid, const std::string& valid,
                            const std::string& description) {
    return {[=](const std::string& text) {
                double value = 0;
                const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                const bool is_number = error == std::errc() && end == text.data() + text.size();
                return is_number && is_valid(value) ? std::string() : fmt::format("{} is no {}", text, valid);
            },
            description};
}

}  // namespace

CLI::Validator number_in(double low, double high, const std::string& why_low) {
    const std::string why = why_low.empty() ? "" : fmt::format(" ({})", why_low);
    return number_where([=](double value) { return value >= low && value <= high; },
                        fmt::format("number from {:g}{} to {:g}", low, why, high),
                        fmt::format("FLOAT in [{:g} - {:g}]", low, high));
}

CLI::Validator number_above_zero() {
    return number_where([](double value) { return value > 0 && value <= std::numeric_limits<double>::max(); },
                        "finite number above 0", "POSITIVE");
}

}  // namespace aoscore
