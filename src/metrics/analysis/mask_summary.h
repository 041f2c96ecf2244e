#pragma once

#include "metrics/analysis/beyond_threshold.h"
#include "metrics/analysis/pixel_facts.h"
#include "metrics/metric.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The part of a mask by one cause: each pixel is divided among the causes of the truth's occlusion there, in
/// proportion to their occlusion.
struct CauseShare {
    std::string cause;           ///< its name in PixelFacts
    double area = 0;             ///< share of the valid pixels; those of all causes add up to the mask's
    std::optional<double> mean;  ///< mean |test - truth| over that area; empty where there is none
};

/// Missing or false occlusion in numbers: the pixels that are off by more than a threshold. Where the truth's
/// standard error is known, what its noise adds is taken off; see BeyondThreshold.
struct MaskSummary {
    double area = 0;                 ///< share of the valid pixels
    std::optional<double> mean;      ///< mean |test - truth| over the mask; empty where it has no pixel
    std::vector<CauseShare> causes;  ///< in the order of PixelFacts::causes; empty where they are not known
};

struct MeasuredMask {
    MaskSummary summary;
    /// The half width of an interval that holds the area against a truth without noise with 95 % confidence.
    /// Empty where the truth's standard error is not known, for a threshold of 0, and for one that is smaller
    /// than half of the noise of the pixels that may lie beyond it.
    ///
    /// It is 1.96 times the root of two variances. One is that over seeds, of pixels whose noise is normal
    /// and independent of one another: kVarianceOfDoubt times their doubt, over their number. The other is
    /// that over scenes, of what the boxes leave. Errors crowd about a threshold in another way in every
    /// picture, so that it was measured, as a part of the mean doubt: it grows with the root of the noise,
    /// and more where the threshold is as small as the noise. It is too small for a large surface of one
    /// error that lies at the threshold.
    std::optional<double> truth_noise;
    /// The same of the mean. Empty also where the area is not surely more than nothing.
    ///
    /// What moves the area moves the mean by as much of its distance from the threshold, since the pixels
    /// that come or go err by the threshold; those that stay have errors as noisy as they are.
    std::optional<double> mean_noise;
};

/// The variance over seeds of a pixel's share for each unit of its doubt, where errors about the threshold
/// are as frequent on both sides: the integral of the variance of the share of x + z, z normal, over all
/// distances x from the threshold, over that of the doubt.
inline constexpr double kVarianceOfDoubt = 0.5009;

/// `threshold` is in visibility. Throws sizes_differ.
MeasuredMask measure_mask(const MetricInput& input, MaskSide side, double threshold,
                          const std::vector<PixelFacts::Cause>& causes = {});

}  // namespace aoscore
