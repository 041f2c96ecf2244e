#pragma once

#include "core/image.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// What a metric looks at. All images have one size; visibility in [0,1], 1 = open.
struct MetricInput {
    const ImageF& truth;
    const ImageF& test;
    const Mask& valid;                       ///< pixels that count; finite in both images
    const ImageF* standard_error = nullptr;  ///< of the truth, where it is known
};

struct MetricValue {
    std::optional<double> value;  ///< empty where undefined; never NaN
    std::string note;             ///< why it is undefined, or at which pixel it was found
};

/// One metric: a row of the table in metrics.cpp and a file of its own.
struct Metric {
    enum class Better { lower, higher, nearer_zero };
    std::string_view id;  ///< command line, JSON key
    std::string_view label;
    std::string_view unit;  ///< "" for visibility itself
    Better better;
    std::string_view meaning;  ///< one sentence for the page
    std::string_view paper;    ///< author, title, year; "" for elementary ones
    MetricValue (*measure)(const MetricInput&);
};

/// The one table of metrics, in the order of columns.
const std::vector<Metric>& metrics();

/// Pixels of `candidate` where both images are finite. `nonfinite` receives how many were dropped for that.
Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite);

/// Where occlusion is missing (test brighter than the truth by more than `threshold`) and where it is false
/// (darker).
struct OcclusionMasks {
    Mask missing;
    Mask false_occlusion;
    double missing_area = 0;  ///< fraction of valid pixels
    double false_area = 0;
};
OcclusionMasks occlusion_masks(const MetricInput& input, double threshold = 0.1);

}  // namespace aoscore
