#pragma once

#include "metrics/metric.h"

#include <functional>
#include <optional>
#include <string>

namespace aoscore {

inline constexpr const char* kNoValidPixel = "no valid pixel";
inline constexpr const char* kNotFinite = "a valid pixel is NaN or infinite";

/// The value, or an empty one with the note kNotFinite when it is NaN or infinite.
MetricValue defined(double value, std::string note = {});
/// An empty value and why it is empty.
MetricValue undefined(std::string why);

/// Throws sizes_differ unless all images of the input have one size.
void require_one_size(const MetricInput& input);

/// Whether any pixel counts. Throws sizes_differ unless all images have one size.
bool has_valid_pixel(const MetricInput& input);

/// Mean of term(test - truth) over the valid pixels; empty without any. Rows are summed on all cores, their
/// sums in order.
std::optional<double> mean_over_valid(const MetricInput& input, const std::function<double(double)>& term);
std::optional<double> mean_squared_error(const MetricInput& input);

}  // namespace aoscore
