#pragma once

#include "results/results.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// What limits can be put on: every metric, and the areas of missing and false occlusion
/// (mask_areas()), by id.
std::vector<std::string> limited_ids();
/// Their values of one comparison; the areas are not there without an analysis.
MetricMap limited_measures(const MetricMap& metrics, const std::optional<ErrorAnalysis>& analysis);

/// A limit on a measure, written as what must not be: "rmse>0.02", blanks allowed.
struct Gate {
    enum class Relation { greater, greater_equal, less, less_equal };
    std::string metric;
    Relation relation = Relation::greater;
    double threshold = 0;
    std::string text;

    /// Throws usage_error for another form or an unknown measure, listing what is known.
    static Gate parse(const std::string& text);

    /// Whether the measured value breaks the limit. A value that could not be had breaks every limit.
    bool tripped_by(const MetricMap& metrics) const;

    /// The nearest limit of its kind, of four digits, that a value does not break.
    Gate passing(double value) const;

    /// One line: the measured value and the limit that would have passed.
    std::string explain(const MetricMap& metrics) const;
};

}  // namespace aoscore
