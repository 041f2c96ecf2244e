#include "metrics/bootstrap.h"

#include "core/error.h"
#include "metrics/over_views.h"

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

/// What is summed over the blocks drawn; MS-SSIM is no sum, but drawn as well.
enum Sum : std::size_t {
    kCount,
    kSquared,
    kAbsolute,
    kSigned,
    kVariance,
    kMissing,
    kFalse,
    kSsim,
    kSsimWeight,
    kFlip,
    kSums,
    kMsSsim = kSums
};
using Drawn = std::array<double, kSums + 1>;

/// An image as it is drawn from. What it lacks is NaN.
class Urn {
  public:
    explicit Urn(const BlockErrors& image) : blocks_(image.counts.size()), maps_(image.maps) {
        fill(kCount, image.counts);
        fill(kSquared, image.squared_sums);
        fill(kAbsolute, image.absolute_sums);
        fill(kSigned, image.signed_sums);
        fill(kVariance, image.variance_sums);
        fill(kMissing, image.missing_counts);
        fill(kFalse, image.false_counts);
        fill(kSsim, image.maps.ssim_sums);
        fill(kSsimWeight, image.maps.ssim_weights);
        fill(kFlip, image.maps.flip_sums);
    }

    /// Squares for MS-SSIM come from a generator of their own: they are other than the blocks.
    Drawn draw(std::mt19937_64& random, std::mt19937_64& random_squares) const {
        Drawn sums{};
        for (std::size_t k = 0; k < blocks_.size(); ++k) {
            const Drawn& block = blocks_[random() % blocks_.size()];
            for (std::size_t s = 0; s < kSums; ++s) sums[s] += block[s];
        }
        sums[kMsSsim] = draw_ms_ssim(random_squares);
        return sums;
    }

  private:
    double draw_ms_ssim(std::mt19937_64& random) const {
        if (!maps_.ms_ssim) return kNotThere;
        const std::vector<double>& influences = maps_.ms_ssim_influences;
        double moved = 0;
        for (std::size_t k = 0; k < influences.size(); ++k) moved += influences[random() % influences.size()];
        // To first order only; the index has no value above 1.
        return std::min(1.0, *maps_.ms_ssim * std::exp(moved));
    }

    void fill(Sum sum, const std::vector<double>& values) {
        for (std::size_t b = 0; b < blocks_.size(); ++b)
            blocks_[b][sum] = values.size() == blocks_.size() ? values[b] : kNotThere;
    }

    std::vector<Drawn> blocks_;
    const MapSums& maps_;
};

struct Statistic {
    const char* measure;
    double (*value)(const Drawn& sums);
};

constexpr std::array<Statistic, 10> kStatistics{{
    {"rmse", [](const Drawn& s) { return std::sqrt(s[kSquared] / s[kCount]); }},
    // Not std::max, which would turn NaN into 0.
    {"rmse_debiased",
     [](const Drawn& s) {
         const double mse = (s[kSquared] - s[kVariance]) / s[kCount];
         return mse < 0 ? 0.0 : std::sqrt(mse);
     }},
    {"mae", [](const Drawn& s) { return s[kAbsolute] / s[kCount]; }},
    {"bias", [](const Drawn& s) { return s[kSigned] / s[kCount]; }},
    {"psnr", [](const Drawn& s) { return -10 * std::log10(s[kSquared] / s[kCount]); }},
    {"ssim", [](const Drawn& s) { return s[kSsim] / s[kSsimWeight]; }},
    {"flip", [](const Drawn& s) { return s[kFlip] / s[kCount]; }},
    {"ms_ssim", [](const Drawn& s) { return s[kMsSsim]; }},
    {kMissingArea, [](const Drawn& s) { return s[kMissing] / s[kCount]; }},
    {kFalseArea, [](const Drawn& s) { return s[kFalse] / s[kCount]; }},
}};

const Statistic& statistic(const std::string& measure) {
    const auto found = std::ranges::find(kStatistics, measure, &Statistic::measure);
    if (found == kStatistics.end()) throw internal_error("no bootstrap of " + measure);
    return *found;
}

/// Values of several statistics from the same draws.
std::vector<std::vector<double>> resampled_together(std::span<const Statistic> statistics,
                                                    BootstrapImages images, std::uint64_t seed) {
    std::vector<Urn> urns;
    for (const BlockErrors* image : images) urns.emplace_back(*image);
    std::vector<std::vector<double>> values(statistics.size());
    std::vector<std::vector<double>> of_views(statistics.size(), std::vector<double>(urns.size()));
    std::mt19937_64 random(seed), random_squares(seed);
    for (int i = 0; i < kResamples; ++i) {
        for (std::size_t k = 0; k < urns.size(); ++k) {
            const Urn& urn = urns[urns.size() == 1 ? 0 : random() % urns.size()];
            const Drawn drawn = urn.draw(random, random_squares);
            for (std::size_t s = 0; s < statistics.size(); ++s)
                of_views[s][k] = drawn[kCount] > 0 ? statistics[s].value(drawn) : kNotThere;
        }
        for (std::size_t s = 0; s < statistics.size(); ++s)
            values[s].push_back(measure_over_views(statistics[s].measure, of_views[s]));
    }
    return values;
}

}  // namespace

const std::vector<std::string>& bootstrap_measures() {
    static const std::vector<std::string> ids = [] {
        std::vector<std::string> list;
        for (const Statistic& row : kStatistics) list.emplace_back(row.measure);
        return list;
    }();
    return ids;
}

std::vector<double> resampled(const std::string& measure, BootstrapImages images, std::uint64_t seed) {
    return resampled_together({&statistic(measure), 1}, images, seed).front();
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
            intervals[kStatistics[s].measure] = *interval;
    }
    return intervals;
}

}  // namespace aoscore
