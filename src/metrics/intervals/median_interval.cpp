#include "metrics/intervals/median_interval.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::optional<MedianInterval> median_interval(std::vector<double> values, double confidence) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    // P(the median lies below the k-th or above the n+1-k-th) is twice the binomial's tail below k.
    double term = std::pow(0.5, static_cast<double>(n));
    double tail = 0;
    std::size_t k = 0;
    while (2 * k < n && 2 * (tail + term) <= 1 - confidence) {
        tail += term;
        term *= static_cast<double>(n - k) / static_cast<double>(k + 1);
        ++k;
    }
    if (k == 0) return std::nullopt;
    return MedianInterval{values[k - 1], values[n - k]};
}

}  // namespace aoscore
