#pragma once

#include "metrics/metric.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace aoscore {

/// Evaluates metrics of the table by id: those named, or all of them when `ids` is empty. Where the truth has
/// two halves, metrics that allow it are those against a truth without noise (Metric::noise). Where a valid
/// pixel is NaN or infinite, or none is valid, every value is empty with a note that says so (see
/// finite_pixels). Throws sizes_differ for images of several sizes and usage_error for an unknown id.
std::map<std::string, MetricValue> evaluate(const MetricInput& input, std::span<const std::string> ids = {});

/// The metric of this id. Throws usage_error that lists the known ids.
const Metric& metric(std::string_view id);

/// The ids of the metrics that are also measured before the filter and against a method's own truth.
std::vector<std::string> unranked_metrics();

/// The metrics among `ids` (or all, when it is empty) that a truth whose noise has this mean variance can
/// measure: the noise may make the others wrong by more than their correction.
std::vector<std::string> told_metrics(double noise_variance, std::span<const std::string> ids = {});

}  // namespace aoscore
