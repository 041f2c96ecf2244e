#pragma once

#include <span>
#include <string_view>

namespace aoscore {

/// Functions that average a number over several views. All views count the same, whatever their number of
/// valid pixels. `values` is not empty; NaN among them gives NaN.
namespace over_views {
double mean(std::span<const double> values);
/// The root of the mean square, for errors that are roots of mean squares themselves.
double root_mean_square(std::span<const double> values);
/// The decibels of the mean square, for ratios to a peak of 1 in decibels.
double decibels(std::span<const double> values);
double largest(std::span<const double> values);
}  // namespace over_views

/// The value over views of a metric, by the function in its row, or of a mask's area, by the mean. Rankings,
/// sweeps and the bootstrap all use it. Throws internal_error for another id.
double measure_over_views(std::string_view id, std::span<const double> values);

}  // namespace aoscore
