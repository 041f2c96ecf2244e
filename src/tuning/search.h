#pragma once

#include "tuning/search_axis.h"

#include <functional>
#include <vector>

namespace aoscore {

/// How much a search may try, in settings.
struct SearchEffort {
    int global = 60;
    int local = 40;
};

/// Values of the axes, in their order.
using Settings = std::vector<double>;

/// A goal to minimise, and what settings must keep: `excess` is how far they go beyond the budget, as a part
/// of it; 0 or less where they keep it. Both are functions of settings alone.
struct SearchGoal {
    std::function<double(const Settings&)> loss;
    std::function<double(const Settings&)> excess;  ///< null: no budget
};

/// The settings of least loss that keep the budget, found from `begin`: by DIRECT-L over all of the space
/// (Gablonsky and Kelley, A locally-biased form of the DIRECT algorithm, 2001), then from the best of those
/// and `begin` by Subplex (Rowan, Functional stability analysis of numerical algorithms, 1990), both of
/// NLopt; then single values, back to those of `begin`, and whole numbers by one up and down, until none
/// helps. It is deterministic. Throws
/// usage_error where nothing that it tried keeps the budget.
Settings best_settings(const std::vector<SearchAxis>& axes, const SearchGoal& goal, const Settings& begin,
                       const SearchEffort& effort);

}  // namespace aoscore
