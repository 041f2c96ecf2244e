#pragma once

#include <optional>
#include <vector>

namespace aoscore {

/// What something costs and how wrong it is; less is better of both. Empty where it could not be had.
struct CostAndError {
    std::optional<double> cost, error;
};

/// Whether each of them is on the Pareto front: nothing else costs no more and errs no more, with one of the
/// two less. What lacks a number is not on it.
std::vector<bool> pareto_front(const std::vector<CostAndError>& all);

}  // namespace aoscore
