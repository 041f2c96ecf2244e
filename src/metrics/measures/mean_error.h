#pragma once

#include "metrics/metric.h"

#include <cstddef>
#include <functional>
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

/// A sum over valid pixels, and their number.
struct PixelSum {
    double sum = 0;
    std::size_t count = 0;
    /// The mean; empty without a pixel.
    std::optional<double> mean() const;
};
/// Sums row(y) for every row of the image, on all cores; rows are added in order.
PixelSum sum_of_rows(int height, const std::function<PixelSum(int y)>& row);

/// Mean of term(test - truth) over the valid pixels; empty without any.
template <class Term>
std::optional<double> mean_over_valid(const MetricInput& input, Term term) {
    require_one_size(input);
    const auto row = [&](int y) {
        PixelSum all;
        const std::size_t first = input.valid.index(0, y);
        for (std::size_t i = first; i < first + static_cast<std::size_t>(input.valid.width); ++i) {
            if (input.valid.pixels[i] == 0) continue;
            all.sum += term(double{input.test.pixels[i]} - double{input.truth.pixels[i]});
            ++all.count;
        }
        return all;
    };
    return sum_of_rows(input.valid.height, row).mean();
}
std::optional<double> mean_squared_error(const MetricInput& input);

}  // namespace aoscore
