#pragma once

#include "core/image.h"

#include <optional>

namespace aoscore {

/// How much each pixel counts: 1 where it is valid, else 0.
ImageF weights_of(const Mask& valid);

inline constexpr int kSsimBorder_px = 5;  ///< half of the 11x11 window, left out all around

/// Where the weight (0 to 1) is 0 the images may hold anything. Weighted means of the structural similarity
/// index and of its contrast-and-structure factor, over the pixels that are at least kSsimBorder_px inside.
/// The moments of the 11x11 Gaussian window (standard deviation 1.5, K1 0.01, K2 0.03, range 1, population
/// covariance) are normalised convolutions: pixels of weight 0 contribute nothing. Empty when no pixel with a
/// weight is left. Zhou Wang, Alan Bovik, Hamid Sheikh, Eero Simoncelli, "Image Quality Assessment: From
/// Error Visibility to Structural Similarity", 2004; Hans Knutsson, Carl-Fredrik Westin, "Normalized and
/// Differential Convolution", 1993.
struct SsimMeans {
    double ssim = 0;
    double contrast_structure = 0;
};
std::optional<SsimMeans> structural_similarity(const ImageF& truth, const ImageF& test, const ImageF& weight);

}  // namespace aoscore
