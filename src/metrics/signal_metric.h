#pragma once

#include "core/image.h"
#include "core/signal.h"
#include "metrics/analysis/repeats.h"
#include "metrics/metric.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The input of a metric of a signal beside visibility. All planes have one size.
struct SignalInput {
    const SignalImage& truth;
    const SignalImage& test;
    const Mask& valid;             ///< pixels that count; finite in both images
    const ImageF& standard_error;  ///< the truth's, in radians
};

/// One metric of such a signal: a row of the table in signal_metrics.cpp and a file of its own.
struct SignalMetric {
    std::string_view id;     ///< JSON key
    std::string_view label;  ///< the label of a column
    std::string_view unit;
    std::string_view signal;  ///< the id of the signal that it measures
    int decimals = 2;
    std::string_view meaning;  ///< one sentence for the page
    MetricValue (*measure)(const SignalInput&);
};

/// The one table of them, in the order of columns. Lower is better in all.
const std::vector<SignalMetric>& signal_metrics();

/// Evaluates every metric of the table for `signal`, by id. Where a valid pixel is NaN or infinite, or none
/// is valid, every value is empty with a note. Throws sizes_differ for planes of several sizes.
std::map<std::string, MetricValue> evaluate_signal(std::string_view signal, const SignalInput& input);

/// The errors of a signal's angles by block: of directions the angle between both, of an angle the difference
/// test - truth. Without blocks where a pixel that counts is NaN or infinite. Throws sizes_differ.
AngleBlocks angle_blocks(const SignalInput& input);

/// The same errors pixel by pixel, degrees; NaN where a pixel does not count. Throws sizes_differ.
ImageF angle_error_image(const SignalInput& input);

}  // namespace aoscore
