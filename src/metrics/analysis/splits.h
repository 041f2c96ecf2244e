#pragma once

#include "metrics/analysis/pixel_divisions.h"
#include "metrics/analysis/pixel_facts.h"
#include "metrics/metric.h"

#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// The error of the pixels in one bin.
struct SplitBin {
    std::string label;                 ///< "0.1 to 0.25", "hidden"
    double share = 0;                  ///< share of the valid pixels
    double error_share = 0;            ///< share of the sum of squared errors over all valid pixels
    std::optional<double> rmse;        ///< over the bin; empty where it has no pixel
    std::optional<double> bias;        ///< mean of test - truth over the bin
    std::optional<double> noise_rmse;  ///< RMSE by the truth's noise alone; empty where unknown
};

/// The valid pixels divided by one property; the bins' shares add up to 1.
struct Split {
    std::string id;       ///< "tilt"
    std::string label;    ///< "Tilt of the surface"
    std::string unit;     ///< unit of the bins' bounds; "" for names and pure numbers
    std::string meaning;  ///< one sentence
    std::vector<SplitBin> bins;
};

/// Splits by sign of the error and cause of the occlusion (where it is known), then by each of `divisions`,
/// which are pixel_divisions() of the input's mask and these facts. Bins that are not names have fixed
/// bounds, except view depth, whose bins hold a fifth of the pixels each. Empty without a valid pixel. Throws
/// sizes_differ.
std::vector<Split> error_splits(const MetricInput& input, const PixelFacts& facts,
                                const std::vector<PixelDivision>& divisions);
/// Does the same where the divisions are needed only once.
std::vector<Split> error_splits(const MetricInput& input, const PixelFacts& facts);

}  // namespace aoscore
