#pragma once

#include <vector>

namespace aoscore {

/// What rivals give at a cost, between the two that cost less and more, by the logarithm of the cost; the
/// dearest one's where all cost less, and the cheapest one's where all cost more, which favours it. NaN where
/// a cost is not above 0.
double at_cost(double cost, const std::vector<double>& rival_costs, const std::vector<double>& rival_values);

}  // namespace aoscore
