#pragma once

#include "metrics/metric.h"

#include <optional>
#include <string>

namespace aoscore {

inline constexpr const char* kNoValidPixel = "no valid pixel";
inline constexpr const char* kNotFinite = "a valid pixel is NaN or infinite";

/// The value, or an empty one with the note kNotFinite when it is NaN or infinite.
MetricValue defined(double value, std::string note = {});
/// An empty value, with the reason as its note.
MetricValue undefined(std::string why);

/// Throws sizes_differ unless all images of the input have one size.
void require_one_size(const MetricInput& input);

/// Whether any pixel counts. Throws sizes_differ unless all images have one size.
bool has_valid_pixel(const MetricInput& input);

/// Sums over valid pixels of test - truth.
struct DifferenceSums {
    double count = 0, signed_sum = 0, absolute = 0, squared = 0;

    void add(const DifferenceSums& other) {
        count += other.count;
        signed_sum += other.signed_sum;
        absolute += other.absolute;
        squared += other.squared;
    }
};

/// Adds the rows on all cores, and then the sums in order; or takes them from `input.shared`. Throws
/// sizes_differ unless all images have one size.
DifferenceSums difference_sums(const MetricInput& input);
/// The same of values themselves, as if they differed from 0.
DifferenceSums value_sums(const ImageF& values, const Mask& valid);

/// Means over the valid pixels; empty without any. Throw sizes_differ.
std::optional<double> mean_error(const MetricInput& input);
std::optional<double> mean_absolute_error(const MetricInput& input);
std::optional<double> mean_squared_error(const MetricInput& input);

}  // namespace aoscore
