#pragma once

#include "metrics/analysis/pixel_facts.h"
#include "metrics/metric.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Masks of missing occlusion (test brighter than the truth) and false occlusion (darker): by more than a
/// threshold and, where the truth's standard error is known, by more than three of them.
struct OcclusionMasks {
    Mask missing;
    Mask false_occlusion;
    double missing_area = 0;  ///< share of the valid pixels
    double false_area = 0;
};
inline constexpr double kMaskThreshold = 0.1;     ///< the default, in visibility
inline constexpr double kMaskStandardErrors = 3;  ///< noise alone exceeds it in one of 370 pixels
/// Throws sizes_differ.
OcclusionMasks occlusion_masks(const MetricInput& input, double threshold = kMaskThreshold);

/// The part of a mask by one cause: each pixel is divided among the causes of the truth's occlusion there, in
/// proportion to their occlusion.
struct CauseShare {
    std::string cause;           ///< its name in PixelFacts
    double area = 0;             ///< share of the valid pixels; those of all causes add up to the mask's
    std::optional<double> mean;  ///< mean |test - truth| over that area; empty where there is none
};

/// One mask in numbers.
struct MaskSummary {
    double area = 0;                 ///< share of the valid pixels
    std::optional<double> mean;      ///< mean |test - truth| over the mask; empty where it has no pixel
    std::vector<CauseShare> causes;  ///< in the order of PixelFacts::causes; empty where they are not known
};
MaskSummary summarize_mask(const Mask& mask, const MetricInput& input,
                           const std::vector<PixelFacts::Cause>& causes);

}  // namespace aoscore
