#pragma once

#include <span>
#include <string_view>

namespace aoscore {

/// How one number is made of those of several views. Every view counts the same, however many of its pixels
/// are valid. `values` is not empty; NaN among them gives NaN.
namespace over_views {
double mean(std::span<const double> values);
/// For errors that are roots of mean squares themselves: the root of the mean square over all views.
double root_mean_square(std::span<const double> values);
/// For ratios to a peak of 1 in decibels: that of the mean square over all views.
double decibels(std::span<const double> values);
double largest(std::span<const double> values);
}  // namespace over_views

/// The number over views of a metric or of a mask's area, by its id, as the table of metrics says; areas are
/// averaged. What rankings, sweeps and the bootstrap use alike. Throws internal_error for another id.
double measure_over_views(std::string_view id, std::span<const double> values);

}  // namespace aoscore
