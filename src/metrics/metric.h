#pragma once

#include "core/image.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

struct MapSums;

/// What a metric looks at. All images have one size; visibility in [0,1], 1 = open.
struct MetricInput {
    const ImageF& truth;
    const ImageF& test;
    const Mask& valid;                       ///< pixels that count; finite in both images
    const ImageF* standard_error = nullptr;  ///< of the truth, where it is known
    MapSums* maps = nullptr;  ///< where metrics that are means of a map leave what they add up, if wanted
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
    double (*over_views)(std::span<const double>);  ///< of one value a view; see over_views.h
};

/// The one table of metrics, in the order of columns.
const std::vector<Metric>& metrics();

/// Pixels of `candidate` where both images are finite. `nonfinite` receives how many were dropped for that.
Mask finite_pixels(const ImageF& truth, const ImageF& test, const Mask& candidate, std::size_t& nonfinite);

}  // namespace aoscore
