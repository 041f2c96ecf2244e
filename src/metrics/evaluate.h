#pragma once

#include "metrics/metric.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// Metrics of the table by id: those named, or all of them when `ids` is empty. Where the truth has two
/// halves, those that can be are extrapolated to a truth without noise (Metric::noise). Where a valid pixel
/// is NaN or infinite, or none is valid, every value is empty with a note that says so (see finite_pixels).
/// Throws sizes_differ for images of several sizes and usage_error for an unknown id.
std::map<std::string, MetricValue> evaluate(const MetricInput& input, std::span<const std::string> ids = {});

/// The row of the table. Throws usage_error that lists the known ids.
const Metric& metric(std::string_view id);

/// The ids of the metrics that are measured before the filter and against a method's own truth, too.
std::vector<std::string> unranked_metrics();

/// Those of `ids` (of all metrics when it is empty) that a truth whose noise has this mean variance can tell:
/// the others are extrapolated, and may be off by more than what the extrapolation takes off.
std::vector<std::string> told_metrics(double noise_variance, std::span<const std::string> ids = {});

}  // namespace aoscore
