#pragma once

#include <optional>
#include <vector>

namespace aoscore {

/// The median of at least one value: the middle one, or the mean of the two in the middle.
double median(std::vector<double> values);

/// An interval that holds the median of the values' distribution.
struct MedianInterval {
    double low = 0, high = 0;
};

/// The interval between two of the values that holds the median with at least this confidence, for any
/// distribution (by the sign test; Conover, Practical Nonparametric Statistics, 1999). Empty where there are
/// too few: 95 % needs six.
std::optional<MedianInterval> median_interval(std::vector<double> values, double confidence = 0.95);

}  // namespace aoscore
