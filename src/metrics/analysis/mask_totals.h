#pragma once

#include "metrics/analysis/pixel_facts.h"
#include "metrics/metric.h"

#include <vector>

namespace aoscore {

/// Shares of pixels beyond a threshold, and the errors over them.
struct SharedError {
    double share = 0, error = 0;
    void add(double more_share, double more_error) {
        share += more_share;
        error += more_error;
    }
};

/// The pixels of missing or of false occlusion, summed as BeyondThreshold has them.
struct MaskTotal {
    SharedError whole;
    std::vector<SharedError> by_cause;  ///< pixels divided as CauseShare says
    double doubt = 0;
    double doubtful_noise = 0;  ///< of the standard errors, times the doubt
    double variance = 0;        ///< of their squares, times the share
    /// Sums of the shares and of the errors over the blocks of BlockGrid.
    std::vector<double> share_blocks, error_blocks;
};

struct MaskTotals {
    double valid = 0;  ///< pixels
    MaskTotal missing, false_occlusion;
};

/// Sums both masks in one pass; the causes are for missing occlusion. Beyond a threshold of 0 every
/// difference counts, also one by the truth's noise. Throws sizes_differ.
MaskTotals mask_totals(const MetricInput& input, double threshold,
                       const std::vector<PixelFacts::Cause>& causes = {});

}  // namespace aoscore
