#include "metrics/analysis/mask_summary.h"

#include "metrics/analysis/beyond_threshold.h"
#include "metrics/measures/bands.h"
#include "metrics/measures/mean_error.h"
#include "metrics/measures/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

constexpr double kDeviations = 1.96;  // these hold 95 % of a normal distribution
/// What the boxes leave, as a part of the mean doubt, for a noise of 1, and how much faster it grows where the
/// noise is not small against the threshold: chosen so that of six scenes, ten images and 16 to 64 rays, at
/// thresholds of .05 to .2, as many intervals hold the value from 4,096 rays as they say.
constexpr double kLeftByRoot = 0.33, kLeftNearNoise = 3;

/// Sums of weighted errors.
struct ErrorSums {
    double weight = 0, error = 0;
    void add(double more_weight, double more_error) {
        weight += more_weight;
        error += more_error;
    }
};

/// The sums over a mask, and over the part of each cause.
struct MaskSums {
    double valid = 0, doubt = 0;
    ErrorSums whole;
    std::vector<ErrorSums> by_cause;

    void add(const MaskSums& other) {
        valid += other.valid;
        doubt += other.doubt;
        whole.add(other.whole.weight, other.whole.error);
        for (std::size_t c = 0; c < by_cause.size(); ++c)
            by_cause[c].add(other.by_cause[c].weight, other.by_cause[c].error);
    }
};

void add_causes(const BeyondThreshold& beyond, const std::vector<PixelFacts::Cause>& causes, std::size_t i,
                MaskSums& sums) {
    double occlusion = 0;
    for (const PixelFacts::Cause& cause : causes) occlusion += double{cause.occlusion->pixels[i]};
    if (occlusion <= 0) return;
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const double part = double{causes[c].occlusion->pixels[i]} / occlusion;
        sums.by_cause[c].add(part * beyond.share, part * beyond.error);
    }
}

MaskSums sums_of_rows(const MetricInput& input, MaskSide side, double threshold,
                      const std::vector<PixelFacts::Cause>& causes, int first_row, int rows) {
    MaskSums sums;
    sums.by_cause.resize(causes.size());
    const auto width = static_cast<std::size_t>(input.valid.width);
    const std::size_t first = static_cast<std::size_t>(first_row) * width;
    for (std::size_t i = first; i < first + static_cast<std::size_t>(rows) * width; ++i) {
        if (input.valid.pixels[i] == 0) continue;
        ++sums.valid;
        const BeyondThreshold beyond = beyond_threshold(input, i, side, threshold);
        if (beyond.share == 0 && beyond.doubt == 0) continue;
        sums.doubt += beyond.doubt;
        sums.whole.add(beyond.share, beyond.error);
        add_causes(beyond, causes, i, sums);
    }
    return sums;
}

MaskSums sums_of_mask(const MetricInput& input, MaskSide side, double threshold,
                      const std::vector<PixelFacts::Cause>& causes) {
    std::vector<MaskSums> bands(band_count(input.valid.height));
    for_each_band(input.valid.height, [&](std::size_t band, int first_row, int rows) {
        bands[band] = sums_of_rows(input, side, threshold, causes, first_row, rows);
    });
    MaskSums all;
    all.by_cause.resize(causes.size());
    for (const MaskSums& band : bands) all.add(band);
    return all;
}

/// The mean error over an area. Noise cannot bring it below the threshold.
std::optional<double> mean_of(const ErrorSums& sums, double threshold) {
    if (sums.weight <= 0) return std::nullopt;
    return std::clamp(sums.error / sums.weight, threshold, std::max(threshold, 1.0));
}

/// The shares of the causes. One that noise has brought below nothing has none, and the others still add up.
std::vector<CauseShare> cause_shares(const MaskSums& sums, const std::vector<PixelFacts::Cause>& causes,
                                     double area, double threshold) {
    double known = 0, above_nothing = 0;
    for (const ErrorSums& cause : sums.by_cause) {
        known += cause.weight;
        above_nothing += std::max(cause.weight, 0.0);
    }
    const double of_area = sums.whole.weight > 0 ? std::max(known, 0.0) / sums.whole.weight * area : 0.0;
    std::vector<CauseShare> shares;
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const double weight = std::max(sums.by_cause[c].weight, 0.0);
        shares.push_back({causes[c].name, above_nothing > 0 ? weight / above_nothing * of_area : 0.0,
                          mean_of(sums.by_cause[c], threshold)});
    }
    return shares;
}

std::optional<double> half_width(const MetricInput& input, const MaskSums& sums, double threshold) {
    if (input.standard_error == nullptr || sums.valid == 0) return std::nullopt;
    const double noise = std::sqrt(mean_noise_variance(input).value_or(0)), doubt = sums.doubt / sums.valid;
    const double seeds = kVarianceOfDoubt * doubt / sums.valid;
    const double left = kLeftByRoot * doubt * std::sqrt(noise * (1 + kLeftNearNoise * noise / threshold));
    const double half = kDeviations * std::hypot(std::sqrt(seeds), left);
    return std::isfinite(half) ? std::optional(half) : std::nullopt;
}

}  // namespace

MeasuredMask measure_mask(const MetricInput& input, MaskSide side, double threshold,
                          const std::vector<PixelFacts::Cause>& causes) {
    require_one_size(input);
    const MaskSums sums = sums_of_mask(input, side, threshold, causes);
    MeasuredMask mask;
    mask.summary.area = std::max(sums.whole.weight, 0.0) / std::max(sums.valid, 1.0);
    mask.summary.mean = mean_of(sums.whole, threshold);
    mask.summary.causes = cause_shares(sums, causes, mask.summary.area, threshold);
    mask.truth_noise = half_width(input, sums, threshold);
    return mask;
}

}  // namespace aoscore
