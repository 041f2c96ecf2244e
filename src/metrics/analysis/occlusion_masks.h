#pragma once

#include "metrics/metric.h"

namespace aoscore {

/// The pixels to show and to find regions of: where the test is brighter (missing occlusion) or darker (false
/// occlusion) than the truth by more than a threshold and, where the truth's standard error is known, by more
/// than three of them, so that noise is not taken for an error. The share of the pixels that are off by more
/// than the threshold alone is another number, MaskSummary::area; with a sure truth both agree.
struct OcclusionMasks {
    Mask missing;
    Mask false_occlusion;
};
inline constexpr double kMaskThreshold = 0.1;     ///< the default, in visibility
inline constexpr double kMaskStandardErrors = 3;  ///< noise alone exceeds it in one of 370 pixels
/// Throws sizes_differ.
OcclusionMasks occlusion_masks(const MetricInput& input, double threshold = kMaskThreshold);

}  // namespace aoscore
