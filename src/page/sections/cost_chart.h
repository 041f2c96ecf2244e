#pragma once

#include "results/results.h"

#include <string>
#include <vector>

namespace aoscore {

/// A cell that has both a cost and an error.
struct CostPoint {
    const CellRecord* cell;
    double ms, error;
    bool front = false;  ///< never true for a bound, which is not for use
};

/// The run times and errors of a view's cells.
struct CostChart {
    std::string metric;             ///< the id of the error
    std::vector<CostPoint> points;  ///< by cost, then error
    std::string data;               ///< the points for the page's script, as script_json() writes it
};

CostChart cost_chart(const Results& results, const ViewRecord& view);

/// The names of the methods on the Pareto front, cheapest first.
std::vector<std::string> front_names(const CostChart& chart);

}  // namespace aoscore
