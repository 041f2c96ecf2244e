#pragma once

#include "metrics/analysis/mask_summary.h"
#include "metrics/analysis/mask_totals.h"

namespace aoscore {

/// Both masks of a picture, from their totals for that threshold.
struct MeasuredMasks {
    MeasuredMask missing, false_occlusion;
};
MeasuredMasks measured_masks(const MetricInput& input, const MaskTotals& totals, double threshold,
                             const std::vector<PixelFacts::Cause>& causes);

}  // namespace aoscore
