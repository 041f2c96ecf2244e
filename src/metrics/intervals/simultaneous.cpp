#include "metrics/intervals/simultaneous.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>

namespace aoscore {
namespace {

constexpr double kConfidence = 0.95;
/// The factor of one normal difference. Few views give few distinct draws, and no more certainty than that.
constexpr double kLeastFactor = 1.96;
/// Differences smaller than the values by this factor are rounding.
constexpr double kRounding = 1e-12;

/// Calls use(i, difference) for each draw i of both that is a number.
template <class Use>
void for_each_difference(const Resampled& a, const Resampled& b, Use use) {
    if (a.draws.size() != b.draws.size()) throw internal_error("resampled values that do not pair");
    for (std::size_t i = 0; i < a.draws.size(); ++i) {
        const double difference = a.draws[i] - b.draws[i];
        if (std::isfinite(difference)) use(i, difference);
    }
}

/// The standard deviation of the differences; empty where fewer than two draws are numbers.
std::optional<double> deviation(const Resampled& a, const Resampled& b) {
    std::size_t count = 0;
    double mean = 0, squares = 0;  // about the mean (Welford, 1962)
    for_each_difference(a, b, [&](std::size_t, double difference) {
        const double from_mean = difference - mean;
        mean += from_mean / static_cast<double>(++count);
        squares += from_mean * (difference - mean);
    });
    if (count < 2) return std::nullopt;
    return std::sqrt(squares / static_cast<double>(count - 1));
}

double rounding(const Resampled& a, const Resampled& b) {
    return kRounding * std::max(std::abs(a.value), std::abs(b.value));
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::ranges::nth_element(values, at);
    return *at;
}

}  // namespace

std::vector<std::optional<Interval>> simultaneous_intervals(const std::vector<Resampled>& measures,
                                                            const std::vector<MeasurePair>& pairs) {
    std::vector<std::optional<double>> deviations;
    std::vector<double> largest;  // the largest of all pairs, for each draw
    for (const auto& [first, second] : pairs) {
        const Resampled &a = measures.at(first), &b = measures.at(second);
        deviations.push_back(deviation(a, b));
        if (deviations.back().value_or(0) <= rounding(a, b)) continue;
        largest.resize(std::max(largest.size(), a.draws.size()), 0);
        for_each_difference(a, b, [&](std::size_t i, double difference) {
            largest[i] =
                std::max(largest[i], std::abs(difference - (a.value - b.value)) / *deviations.back());
        });
    }
    const double factor = std::max(kLeastFactor, quantile(std::move(largest), kConfidence));
    std::vector<std::optional<Interval>> intervals;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        intervals.emplace_back();
        if (!deviations[p]) continue;
        const Resampled &a = measures[pairs[p].first], &b = measures[pairs[p].second];
        const double difference = a.value - b.value, half = factor * *deviations[p] + rounding(a, b);
        intervals.back() = Interval{difference - half, difference + half};
    }
    return intervals;
}

Ranks::Ranks(const std::vector<Resampled>& measures) : count_(measures.size()) {
    std::vector<MeasurePair> pairs;
    for (std::size_t a = 0; a < count_; ++a) {
        for (std::size_t b = a + 1; b < count_; ++b) pairs.emplace_back(a, b);
    }
    const auto intervals = simultaneous_intervals(measures, pairs);
    differences_.resize(count_ * count_);
    for (std::size_t a = 0; a < count_; ++a) differences_[a * count_ + a] = Interval{};
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        if (!intervals[p]) continue;
        const auto [a, b] = pairs[p];
        differences_[a * count_ + b] = intervals[p];
        differences_[b * count_ + a] = Interval{-intervals[p]->high, -intervals[p]->low};
    }
}

std::optional<Interval> Ranks::difference(std::size_t a, std::size_t b) const {
    return differences_.at(a * count_ + b);
}

bool Ranks::surely_lower(std::size_t a, std::size_t b) const {
    const std::optional<Interval> interval = difference(a, b);
    return interval && interval->high < 0;
}

RankRange Ranks::range(std::size_t measure) const {
    RankRange range{1, static_cast<int>(count_)};
    for (std::size_t other = 0; other < count_; ++other) {
        range.best += surely_lower(other, measure);
        range.worst -= surely_lower(measure, other);
    }
    return range;
}

std::vector<std::size_t> Ranks::ties(std::size_t measure) const {
    std::vector<std::size_t> others;
    for (std::size_t other = 0; other < count_; ++other) {
        if (other != measure && !surely_lower(other, measure) && !surely_lower(measure, other))
            others.push_back(other);
    }
    return others;
}

}  // namespace aoscore
