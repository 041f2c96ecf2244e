#pragma once

#include "metrics/signal_metric.h"

#include <vector>

namespace aoscore {

/// The largest standard error of a truth's angle that counts as known; other pixels are left out.
inline constexpr float kKnownWithin_rad = 0.1745329252F;  // 10 degrees

/// Angles between both directions at every pixel that counts, degrees.
std::vector<double> direction_errors_deg(const SignalInput& input);
/// Differences test - truth of an angle in radians at every pixel that counts, degrees.
std::vector<double> angle_differences_deg(const SignalInput& input);

/// These errors, summed by block.
AngleBlocks blocks_of(const std::vector<double>& errors_deg, const SignalInput& input);

/// These errors as an image, NaN at pixels that do not count.
ImageF image_of(const std::vector<double>& errors_deg, const SignalInput& input);

/// The mean size of these errors, and the size that 95 % of them do not exceed (the nearest rank); a note in
/// both says how many pixels were left out as unknown.
MetricValue mean_size(const std::vector<double>& errors, const SignalInput& input);
MetricValue size_at_95_percent(std::vector<double> errors, const SignalInput& input);

/// The functions behind the table in signal_metrics.cpp.
namespace measure {
MetricValue bent_angle_mean(const SignalInput& input);
MetricValue bent_angle_p95(const SignalInput& input);
MetricValue cone_error_mean(const SignalInput& input);
MetricValue cone_error_p95(const SignalInput& input);
MetricValue cone_bias(const SignalInput& input);
}  // namespace measure

}  // namespace aoscore
