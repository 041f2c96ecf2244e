#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace aoscore {

/// A duration (>= 0 s) as people say it, in the unit that fits: "1 s" at least, "36 s", "12 min", "3 h", "4
/// d".
inline std::string rough_duration(double seconds) {
    if (seconds < 90) return fmt::format("{:.0f} s", std::max(seconds, 1.0));
    if (seconds < 90 * 60.0) return fmt::format("{:.0f} min", seconds / 60);
    if (seconds < 48 * 3600.0) return fmt::format("{:.0f} h", seconds / 3600);
    return fmt::format("{:.0f} d", seconds / 86400);
}

/// A number (>= 1) with two digits that count, without an exponent: "81", "350", "4000000".
inline std::string rough_number(double value) {
    const double step = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(value, 1.0))) - 1));
    return fmt::format("{:.0f}", std::round(value / step) * step);
}

}  // namespace aoscore
