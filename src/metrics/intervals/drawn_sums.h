#pragma once

namespace aoscore {

/// The sums over the blocks that a resampling drew of an image (see BlockErrors). They are NaN where the
/// image lacks them.
struct DrawnSums {
    double count = 0;            ///< valid pixels
    double squared = 0;          ///< sum of (test - truth)^2
    double absolute = 0;         ///< sum of |test - truth|
    double difference = 0;       ///< sum of test - truth
    double variance = 0;         ///< sum of the variance of the truth's noise
    double missing = 0;          ///< pixels of missing occlusion
    double false_occlusion = 0;  ///< pixels of false occlusion
    double ssim = 0;             ///< sum of the index, over `ssim_weight` pixels
    double ssim_weight = 0;
    double flip = 0;     ///< sum of FLIP's map
    double ms_ssim = 0;  ///< the index itself as it was drawn, not a sum

    DrawnSums& operator+=(const DrawnSums& other);
};

}  // namespace aoscore
