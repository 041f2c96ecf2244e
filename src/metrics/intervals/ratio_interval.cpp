#include "metrics/intervals/ratio_interval.h"

#include "metrics/intervals/block_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace aoscore {

std::optional<Interval> ratio_interval(const std::vector<double>& dividends,
                                       const std::vector<double>& divisors) {
    constexpr double kDeviations = 1.96;  // these hold 95 % of a normal distribution
    const auto taking_part = std::ranges::count_if(divisors, [](double divisor) { return divisor != 0; });
    const double divisor = std::accumulate(divisors.begin(), divisors.end(), 0.0);
    if (static_cast<std::size_t>(taking_part) < kFewestBlocks || divisor <= 0) return std::nullopt;
    const double ratio = std::accumulate(dividends.begin(), dividends.end(), 0.0) / divisor;
    double squares = 0;
    for (std::size_t b = 0; b < divisors.size(); ++b) {
        const double distance = dividends[b] - ratio * divisors[b];
        squares += distance * distance;
    }
    const double blocks = static_cast<double>(divisors.size());
    const double half = kDeviations * std::sqrt(squares * blocks / (blocks - 1)) / divisor;
    if (!std::isfinite(half) || half <= 0) return std::nullopt;
    return Interval{ratio - half, ratio + half};
}

}  // namespace aoscore
