#pragma once

#include "results/results.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// The ids of measures that can be limited: every metric, the areas of missing and false occlusion
/// (mask_areas()), every metric of a signal beside visibility, and the errors of light: "light.rmse.cone".
std::vector<std::string> limited_ids();
/// The values of these measures of a cell; those of signals and of light say why they are missing.
MetricMap limited_measures(const CellRecord& cell);
/// The same of a comparison of images, which have visibility alone; without an analysis the areas are
/// missing.
MetricMap limited_measures(const MetricMap& metrics, const std::optional<ErrorAnalysis>& analysis);

/// A limit on a measure, written as the condition that trips it: "rmse>0.02", blanks allowed.
struct Gate {
    enum class Relation { greater, greater_equal, less, less_equal };
    std::string metric;
    Relation relation = Relation::greater;
    double threshold = 0;
    std::string text;

    /// Reads a limit. Throws usage_error for another form or an unknown measure, listing the known ones.
    static Gate parse(const std::string& text);

    /// Whether it is held against a cell of these measures. One on a signal beside visibility, or on light,
    /// is not where the cell lacks the value and others of its run have it (`measured_of_some`, ids): the
    /// method does not give that signal. Where no cell has it, nothing was measured, and every cell is
    /// judged.
    bool judges(const MetricMap& metrics, const std::set<std::string>& measured_of_some) const;

    /// Whether the measured value trips the limit. A missing value trips every limit.
    bool tripped_by(const MetricMap& metrics) const;

    /// The nearest limit of its kind, with four digits, that a value does not trip.
    Gate passing(double value) const;

    /// Says in one line the measured value and the limit that would have passed.
    std::string explain(const MetricMap& metrics) const;
};

}  // namespace aoscore
