#pragma once

#include "core/image.h"
#include "metrics/intervals/block_grid.h"

#include <optional>
#include <vector>

namespace aoscore {

/// How much each pixel counts: 1 where it is valid, else 0.
ImageF weights_of(const Mask& valid);

inline constexpr int kSsimBorder_px = 5;  ///< half of the 11x11 window, left out all around

struct SsimMeans {
    double ssim = 0;
    double contrast_structure = 0;
};

/// Weighted sums over blocks of the structural similarity index and of its contrast-and-structure factor.
struct SsimSums {
    std::vector<double> ssim, contrast_structure, weights;

    SsimSums() = default;
    explicit SsimSums(std::size_t blocks) : ssim(blocks), contrast_structure(blocks), weights(blocks) {}
    void add(const SsimSums& other);
    /// Empty when no pixel has a weight.
    std::optional<SsimMeans> means() const;
};

/// Where the weight (0 to 1) is 0 the images may hold anything. Sums over the pixels that are at least
/// kSsimBorder_px inside, by block of `grid`; the images may be its image halved some times.
/// The moments of the 11x11 Gaussian window (standard deviation 1.5, K1 0.01, K2 0.03, range 1, population
/// covariance) are normalised convolutions: pixels of weight 0 contribute nothing. Zhou Wang, Alan Bovik,
/// Hamid Sheikh, Eero Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity",
/// 2004; Hans Knutsson, Carl-Fredrik Westin, "Normalized and Differential Convolution", 1993.
SsimSums structural_similarity(const ImageF& truth, const ImageF& test, const ImageF& weight,
                               const BlockGrid& grid, int halvings = 0);

}  // namespace aoscore
