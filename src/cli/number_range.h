#pragma once

#include <CLI/CLI.hpp>

namespace aoscore {

/// Accepts the numbers from `low` to `high`. NaN is none of them, which CLI::Range lets pass.
CLI::Validator number_in(double low, double high);

/// Accepts finite numbers above 0.
CLI::Validator number_above_zero();

}  // namespace aoscore
