#include "verdict/equal_cost.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace aoscore {

double at_cost(double cost, const std::vector<double>& rival_costs, const std::vector<double>& rival_values) {
    std::vector<std::pair<double, double>> rivals;
    for (std::size_t i = 0; i < rival_costs.size(); ++i) rivals.emplace_back(rival_costs[i], rival_values[i]);
    std::ranges::sort(rivals);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (rivals.empty() || !(cost > 0) || !(rivals.front().first > 0)) return kNone;
    if (cost < rivals.front().first) return rivals.front().second;
    const auto dearer =
        std::ranges::find_if(rivals, [cost](const auto& rival) { return rival.first > cost; });
    const auto& [low_cost, low_value] = *(dearer - 1);
    if (dearer == rivals.end()) return low_value;
    const double part = std::log(cost / low_cost) / std::log(dearer->first / low_cost);
    return low_value + part * (dearer->second - low_value);
}

}  // namespace aoscore
