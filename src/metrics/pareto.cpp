#include "metrics/pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace aoscore {

std::vector<bool> pareto_front(const std::vector<CostAndError>& all) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].cost && all[i].error) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(*all[a].cost, *all[a].error) < std::pair(*all[b].cost, *all[b].error);
    });
    std::vector<bool> on_front(all.size(), false);
    double least_error = std::numeric_limits<double>::infinity();
    const CostAndError* last = nullptr;
    for (const std::size_t i : order) {
        const bool equals_last =
            last != nullptr && *last->cost == *all[i].cost && *last->error == *all[i].error;
        if (*all[i].error < least_error || equals_last) {
            on_front[i] = true;
            least_error = *all[i].error;
            last = &all[i];
        }
    }
    return on_front;
}

}  // namespace aoscore
