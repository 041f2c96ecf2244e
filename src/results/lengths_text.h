#pragma once

#include "results/results.h"

#include <string>

namespace aoscore {

/// "radius 1 m, sigma 0.256 m, bias 0.01 m (set)": the cell's lengths, with their origin where that is not
/// the view's radius; empty where its method has none.
std::string lengths_text(const CellRecord& cell);

/// The view's radius: "R 0.5 m (named by the view), 28.3 pixels in the median".
std::string radius_text(const ViewRecord& view);

}  // namespace aoscore
