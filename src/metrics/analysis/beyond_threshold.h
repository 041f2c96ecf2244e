#pragma once

#include "metrics/metric.h"

#include <algorithm>
#include <cstddef>

namespace aoscore {

/// Missing occlusion: the test is brighter than the truth. False occlusion: it is darker.
enum class MaskSide { missing, false_occlusion };

/// How much of a pixel is off by more than a threshold, to one side of the truth.
///
/// A truth of few rays moves pixels over a threshold in both directions, and more of them from the side where
/// there are more: the plain share of the pixels beyond it grows with the noise. So every pixel is spread
/// over a box about its own error, whose width follows from the standard error there. Boxes of variance r
/// stand for a noise of 1 + r times the variance, and the line through two of them is followed back to no
/// noise at all, r = -1 (John Cook, Leonard Stefanski, Simulation-Extrapolation Estimation in Parametric
/// Measurement Error Models, 1994). Boxes also even out that few rays yield few different values.
struct BeyondThreshold {
    double share = 0;  ///< may lie outside of [0,1]; the mean over many pixels is their share
    double error = 0;  ///< the error over that share
    double doubt = 0;  ///< how undecided the pixel is in the wide box, 0 to 0.5
};

namespace boxes {

/// The variances of both boxes, as multiples of the noise's, and the weights that follow the line to -1.
inline constexpr double kNarrow = 0.25, kWide = 2;
inline constexpr double kNarrowWeight = (1 + kWide) / (kWide - kNarrow);
inline constexpr double kWideWeight = 1 - kNarrowWeight;
/// Half the widths of boxes of these variances, in standard errors: the roots of three times the variance.
inline constexpr double kNarrowReach = 0.86602540378443865, kWideReach = 2.4494897427831781;

struct Part {
    double share, error;
};

/// The part of a box about `error` beyond the threshold, and the error over it.
inline Part part_beyond(double error, double reach, double threshold) {
    const double highest = error + reach, lowest = error - reach;
    if (highest <= threshold) return {0, 0};
    if (lowest >= threshold) return {1, error};
    const double share = (highest - threshold) / (2 * reach);
    return {share, share * (highest + threshold) / 2};
}

}  // namespace boxes

/// Measures a pixel whose `error`, positive towards the side that is asked for, is known to within
/// `standard_error`. `most` is the largest error that a truth within [0,1] can have on this side: the test's
/// own value where the test is brighter, 1 less that value where it is darker.
inline BeyondThreshold beyond_threshold(double error, double standard_error, double threshold, double most) {
    const double reach = boxes::kWideReach * standard_error;
    if (error + reach <= threshold || most <= threshold) return {};
    if (error - reach > threshold) return {1, error, 0};
    if (reach <= 0) return {};  // the error is the threshold itself
    const boxes::Part wide = boxes::part_beyond(error, reach, threshold);
    const boxes::Part narrow = boxes::part_beyond(error, boxes::kNarrowReach * standard_error, threshold);
    return {boxes::kNarrowWeight * narrow.share + boxes::kWideWeight * wide.share,
            boxes::kNarrowWeight * narrow.error + boxes::kWideWeight * wide.error,
            std::min(wide.share, 1 - wide.share)};
}

/// The same of pixel `i`; exact where the truth's standard error is not known.
inline BeyondThreshold beyond_threshold(const MetricInput& input, std::size_t i, MaskSide side,
                                        double threshold) {
    const double test = double{input.test.pixels[i]}, brighter = test - double{input.truth.pixels[i]};
    const double noise = input.standard_error != nullptr ? double{input.standard_error->pixels[i]} : 0.0;
    return side == MaskSide::missing ? beyond_threshold(brighter, noise, threshold, test)
                                     : beyond_threshold(-brighter, noise, threshold, 1 - test);
}

}  // namespace aoscore
