#pragma once

namespace aoscore {

/// What a resampling drew of an image, summed over the blocks that it drew (see BlockErrors). NaN where the
/// image lacks what is summed.
struct DrawnSums {
    double count = 0;            ///< valid pixels
    double squared = 0;          ///< of (test - truth)^2
    double absolute = 0;         ///< of |test - truth|
    double difference = 0;       ///< of test - truth
    double variance = 0;         ///< of the variance of the truth's noise
    double missing = 0;          ///< pixels of missing occlusion
    double false_occlusion = 0;  ///< pixels of false occlusion
    double ssim = 0;             ///< of the index, over `ssim_weight` pixels
    double ssim_weight = 0;
    double flip = 0;     ///< of FLIP's map
    double ms_ssim = 0;  ///< no sum but the index itself, as it was drawn

    DrawnSums& operator+=(const DrawnSums& other);
};

}  // namespace aoscore
