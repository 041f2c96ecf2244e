#include "metrics/analysis/mask_summary.h"

#include "metrics/analysis/mask_totals.h"
#include "metrics/analysis/measured_masks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace aoscore {
namespace {

constexpr double kDeviations = 1.96;  // these hold 95 % of a normal distribution
/// Noise of more than this many thresholds was not measured, and nothing is stated of it.
constexpr double kMostNoise = 2;
/// What the boxes leave, as a part of the mean doubt, for a noise of 1, and how much faster it grows where
/// the noise is not small against the threshold, and where it is as large: chosen so that of six scenes, ten
/// images and 16 to 64 rays, at thresholds of .05 to .2, as many intervals hold the value from 4,096 rays as
/// they say.
constexpr double kLeftByRoot = 0.25, kLeftNearNoise = 2, kLeftInNoise = 1;

/// The mean error over an area. Noise cannot bring it below the threshold.
std::optional<double> mean_of(const SharedError& sums, double threshold) {
    if (sums.share <= 0) return std::nullopt;
    return std::clamp(sums.error / sums.share, threshold, std::max(threshold, 1.0));
}

/// The shares of the causes. One that noise has brought below nothing has none, and the others still add up.
std::vector<CauseShare> cause_shares(const MaskTotal& total, const std::vector<PixelFacts::Cause>& causes,
                                     double area, double threshold) {
    double known = 0, above_nothing = 0;
    for (const SharedError& cause : total.by_cause) {
        known += cause.share;
        above_nothing += std::max(cause.share, 0.0);
    }
    const double of_area = total.whole.share > 0 ? std::max(known, 0.0) / total.whole.share * area : 0.0;
    std::vector<CauseShare> shares;
    for (std::size_t c = 0; c < total.by_cause.size(); ++c) {
        const double share = std::max(total.by_cause[c].share, 0.0);
        shares.push_back({causes[c].name, above_nothing > 0 ? share / above_nothing * of_area : 0.0,
                          mean_of(total.by_cause[c], threshold)});
    }
    return shares;
}

/// The standard deviation of a mask's pixels about those against a truth without noise.
double deviation(const MaskTotal& total, double threshold) {
    if (total.doubt <= 0) return 0;
    const double noise = total.doubtful_noise / total.doubt, part = noise / threshold;
    const double grown = 1 + kLeftNearNoise * part + kLeftInNoise * part * part * part * part;
    const double left = kLeftByRoot * total.doubt * std::sqrt(noise * grown);
    return std::hypot(std::sqrt(kVarianceOfDoubt * total.doubt), left);
}

std::optional<double> half_width(double deviation) {
    const double half = kDeviations * deviation;
    return std::isfinite(half) ? std::optional(half) : std::nullopt;
}

std::optional<double> half_width_of_mean(const MaskTotal& total, double mean, double threshold) {
    const double of_pixels = deviation(total, threshold);
    if (total.whole.share <= kDeviations * of_pixels) return std::nullopt;
    const double of_errors = std::sqrt(std::max(total.variance, 0.0));
    return half_width(std::hypot((mean - threshold) * of_pixels, of_errors) / total.whole.share);
}

}  // namespace

MeasuredMasks measured_masks(const MetricInput& input, const MaskTotals& totals, double threshold,
                             const std::vector<PixelFacts::Cause>& causes) {
    const auto measured = [&](const MaskTotal& total) {
        MeasuredMask mask;
        mask.summary.area = std::max(total.whole.share, 0.0) / std::max(totals.valid, 1.0);
        mask.summary.mean = mean_of(total.whole, threshold);
        mask.summary.causes = cause_shares(total, causes, mask.summary.area, threshold);
        if (input.standard_error == nullptr || totals.valid == 0 || threshold <= 0) return mask;
        if (total.doubtful_noise > kMostNoise * threshold * total.doubt) return mask;
        mask.truth_noise = half_width(deviation(total, threshold) / totals.valid);
        if (mask.summary.mean) mask.mean_noise = half_width_of_mean(total, *mask.summary.mean, threshold);
        return mask;
    };
    return {measured(totals.missing), measured(totals.false_occlusion)};
}

MeasuredMask measure_mask(const MetricInput& input, MaskSide side, double threshold,
                          const std::vector<PixelFacts::Cause>& causes) {
    MeasuredMasks masks = measured_masks(input, mask_totals(input, threshold, causes), threshold, causes);
    return std::move(side == MaskSide::missing ? masks.missing : masks.false_occlusion);
}

}  // namespace aoscore
