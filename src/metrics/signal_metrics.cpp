#include "metrics/measures/angle_errors.h"
#include "metrics/measures/mean_error.h"
#include "metrics/signal_metric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

bool finite(const SignalImage& image, std::size_t i) {
    return std::ranges::all_of(image, [i](const ImageF& plane) { return std::isfinite(plane.pixels[i]); });
}

/// Throws sizes_differ unless all planes have one size.
void require_one_size(const SignalInput& input) {
    for (const SignalImage* image : {&input.truth, &input.test}) {
        for (const ImageF& plane : *image)
            require_one_size(MetricInput{input.standard_error, plane, input.valid});
    }
}

std::vector<double> angle_errors_deg(const SignalInput& input) {
    return input.truth.size() == 1 ? angle_differences_deg(input) : direction_errors_deg(input);
}

}  // namespace

const std::vector<SignalMetric>& signal_metrics() {
    static const std::vector<SignalMetric> table = {
        {.id = "bent_angle_mean",
         .label = "Mean angle",
         .unit = "°",
         .signal = "bent_normal",
         .meaning = "Mean of the angle between the method's bent normal and the truth's.",
         .measure = measure::bent_angle_mean},
        {.id = "bent_angle_p95",
         .label = "Angle of 95 %",
         .unit = "°",
         .signal = "bent_normal",
         .meaning = "95 % of the pixels have no larger angle.",
         .measure = measure::bent_angle_p95},
        {.id = "cone_error_mean",
         .label = "Mean cone error",
         .unit = "°",
         .signal = "cone_angle",
         .meaning = "Mean size of the difference between both cones' half angles.",
         .measure = measure::cone_error_mean},
        {.id = "cone_error_p95",
         .label = "Cone error of 95 %",
         .unit = "°",
         .signal = "cone_angle",
         .meaning = "95 % of the pixels have no larger difference.",
         .measure = measure::cone_error_p95},
        {.id = "cone_bias",
         .label = "Cone bias",
         .unit = "°",
         .signal = "cone_angle",
         .meaning = "Mean of test minus truth: above 0 the cones are too wide.",
         .measure = measure::cone_bias},
    };
    return table;
}

std::map<std::string, MetricValue> evaluate_signal(std::string_view signal, const SignalInput& input) {
    require_one_size(input);
    std::size_t nonfinite = 0;
    for (std::size_t i = 0; i < input.valid.size(); ++i) {
        const bool all = finite(input.truth, i) && finite(input.test, i);
        nonfinite += input.valid.pixels[i] != 0 && !all;
    }
    std::map<std::string, MetricValue> values;
    for (const SignalMetric& row : signal_metrics()) {
        if (row.signal != signal) continue;
        values[std::string(row.id)] =
            nonfinite == 0 ? row.measure(input)
                           : undefined(fmt::format("{} valid pixels are NaN or infinite", nonfinite));
    }
    return values;
}

AngleBlocks angle_blocks(const SignalInput& input) {
    require_one_size(input);
    return blocks_of(angle_errors_deg(input), input);
}

ImageF angle_error_image(const SignalInput& input) {
    require_one_size(input);
    return image_of(angle_errors_deg(input), input);
}

}  // namespace aoscore
