#include "metrics/bootstrap.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace aoscore {
namespace {

constexpr int kResamples = 2000;
constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

/// Sums over the blocks drawn.
struct Totals {
    double count = 0, squared = 0, absolute = 0, signed_sum = 0, variance = 0;

    void add(const BlockErrors& blocks, std::size_t block) {
        count += blocks.counts[block];
        squared += blocks.squared_sums[block];
        absolute += blocks.absolute_sums[block];
        signed_sum += blocks.signed_sums[block];
        variance += blocks.variance_sums.empty() ? kNotThere : blocks.variance_sums[block];
    }
};

struct Statistic {
    const char* metric;
    double (*value)(const Totals& totals);
};

constexpr std::array<Statistic, 5> kStatistics{{
    {"rmse", [](const Totals& t) { return std::sqrt(t.squared / t.count); }},
    // Not std::max, which would turn NaN into 0.
    {"rmse_debiased",
     [](const Totals& t) {
         const double mse = (t.squared - t.variance) / t.count;
         return mse < 0 ? 0.0 : std::sqrt(mse);
     }},
    {"mae", [](const Totals& t) { return t.absolute / t.count; }},
    {"bias", [](const Totals& t) { return t.signed_sum / t.count; }},
    {"psnr", [](const Totals& t) { return -10 * std::log10(t.squared / t.count); }},
}};

const Statistic& statistic(const std::string& metric) {
    const auto found = std::ranges::find(kStatistics, metric, &Statistic::metric);
    if (found == kStatistics.end()) throw internal_error("no bootstrap of " + metric);
    return *found;
}

/// Draws images and blocks of them, and calls take(totals) for each image drawn.
template <class Take>
void resample(BootstrapImages images, std::mt19937_64& random, Take take) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const BlockErrors& image = *images[images.size() == 1 ? 0 : random() % images.size()];
        const std::size_t blocks = image.counts.size();
        Totals totals;
        for (std::size_t k = 0; k < blocks; ++k) totals.add(image, random() % blocks);
        take(totals);
    }
}

/// Values of several statistics from the same draws.
std::vector<std::vector<double>> resampled_together(std::span<const Statistic> statistics,
                                                    BootstrapImages images, std::uint64_t seed) {
    std::vector<std::vector<double>> values(statistics.size());
    std::mt19937_64 random(seed);
    for (int i = 0; i < kResamples; ++i) {
        std::vector<double> sums(statistics.size());
        resample(images, random, [&](const Totals& totals) {
            for (std::size_t s = 0; s < sums.size(); ++s)
                sums[s] += totals.count > 0 ? statistics[s].value(totals) : kNotThere;
        });
        for (std::size_t s = 0; s < sums.size(); ++s)
            values[s].push_back(sums[s] / static_cast<double>(images.size()));
    }
    return values;
}

}  // namespace

std::vector<double> resampled(const std::string& metric, BootstrapImages images, std::uint64_t seed) {
    return resampled_together({&statistic(metric), 1}, images, seed).front();
}

std::optional<Interval> confidence_interval(std::vector<double> values) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) return std::nullopt;
    std::ranges::sort(values);
    if (!std::isfinite(values.front()) || !std::isfinite(values.back())) return std::nullopt;
    const auto quantile = [&](double q) {
        return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
    };
    return Interval{quantile(0.025), quantile(0.975)};
}

std::optional<Interval> confidence_interval(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) throw internal_error("resampled values that do not pair");
    std::vector<double> differences(a.size());
    std::ranges::transform(a, b, differences.begin(), std::minus<>());
    return confidence_interval(std::move(differences));
}

std::map<std::string, Interval> confidence_intervals(BootstrapImages images, std::uint64_t seed) {
    const std::vector<std::vector<double>> values = resampled_together(kStatistics, images, seed);
    std::map<std::string, Interval> intervals;
    for (std::size_t s = 0; s < values.size(); ++s) {
        if (const auto interval = confidence_interval(values[s]))
            intervals[kStatistics[s].metric] = *interval;
    }
    return intervals;
}

}  // namespace aoscore
