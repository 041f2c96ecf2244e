#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace aoscore {

/// Accepts the numbers from `low` to `high`. NaN is none of them, which CLI::Range lets pass. `why_low`,
/// where given, says in the error what keeps numbers from being lower.
CLI::Validator number_in(double low, double high, const std::string& why_low = {});

/// Accepts finite numbers above 0.
CLI::Validator number_above_zero();

}  // namespace aoscore
