#pragma once

#include "core/image.h"
#include "metrics/metric.h"

#include <optional>

namespace aoscore {

/// Two images with how much each pixel counts (0 to 1). Where the weight is 0 the values mean nothing.
struct WeightedPair {
    ImageF truth;
    ImageF test;
    ImageF weight;
};
WeightedPair weighted_pair(const MetricInput& input);

inline constexpr int kSsimBorder_px = 5;  ///< half of the 11x11 window, left out all around

/// Weighted means of the structural similarity index and of its contrast-and-structure factor, over the
/// pixels that are at least kSsimBorder_px inside. The moments of the 11x11 Gaussian window (standard
/// deviation 1.5, K1 0.01, K2 0.03, range 1, population covariance) are normalised convolutions: pixels of
/// weight 0 contribute nothing. Empty when no pixel with a weight is left. Zhou Wang, Alan Bovik, Hamid
/// Sheikh, Eero Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004;
/// Hans Knutsson, Carl-Fredrik Westin, "Normalized and Differential Convolution", 1993.
struct SsimMeans {
    double ssim = 0;
    double contrast_structure = 0;
};
std::optional<SsimMeans> structural_similarity(const WeightedPair& pair);

}  // namespace aoscore
