#pragma once

#include <optional>
#include <vector>

namespace aoscore {

/// A cost and an error, of which less is better; empty where missing.
struct CostAndError {
    std::optional<double> cost, error;
};

/// Whether each is on the Pareto front: no other has at most its cost and its error, and less of one. An
/// entry that lacks a number is not on it.
std::vector<bool> pareto_front(const std::vector<CostAndError>& all);

}  // namespace aoscore
