#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// A limit on a metric, written as what must not be: "rmse>0.02".
struct Gate {
    enum class Relation { greater, greater_equal, less, less_equal };
    std::string metric;
    Relation relation = Relation::greater;
    double threshold = 0;
    std::string text;

    /// Throws usage_error for another form or an unknown metric, listing what is known.
    static Gate parse(const std::string& text);

    /// Whether the measured value breaks the limit. A value that could not be had breaks every limit.
    bool tripped_by(const MetricMap& metrics) const;

    /// The nearest limit of its kind, of four digits, that a value does not break.
    Gate passing(double value) const;

    /// One line: the measured value and the limit that would have passed.
    std::string explain(const MetricMap& metrics) const;
};

}  // namespace aoscore
