#pragma once

#include "core/image.h"
#include "metrics/intervals/block_grid.h"
#include "metrics/measures/pixel_weights.h"
#include "metrics/measures/window_moments.h"

#include <optional>
#include <span>
#include <vector>

namespace aoscore {

/// The paper's constants K1 = 0.01 and K2 = 0.03, squared, for a range of 1.
inline constexpr double kSsimC1 = 0.01 * 0.01, kSsimC2 = 0.03 * 0.03;

struct SsimMeans {
    double ssim = 0;
    double contrast_structure = 0;
};

/// Weighted sums over blocks of the structural similarity index and of its contrast-and-structure factor.
struct SsimSums {
    std::vector<double> ssim, contrast_structure, weights;
    std::vector<double> noisy_ssim;  ///< of the index by WindowedImage::noisy_variance; empty without it

    SsimSums() = default;
    SsimSums(std::size_t blocks, bool noisy)
        : ssim(blocks), contrast_structure(blocks), weights(blocks), noisy_ssim(noisy ? blocks : 0) {}
    void add(const SsimSums& other);
    /// The means; empty when no pixel has a weight.
    std::optional<SsimMeans> means() const;
};

/// An image, with its moments where they were computed before.
struct WindowedImage {
    const ImageF& image;
    const WindowMoments* moments = nullptr;
    /// The image's own variance, where `moments` hold that without its noise and both are asked for.
    const Image<double>* noisy_variance = nullptr;
};

/// Sums over the pixels that are at least kSsimBorder_px inside, by block of each grid of the image before it
/// was halved some times. Where the weight is 0 the images may hold anything. The moments of the 11x11
/// Gaussian window (standard deviation 1.5, K1 0.01, K2 0.03, range 1, population covariance) are normalised
/// convolutions, see WindowMoments. Zhou Wang, Alan Bovik, Hamid Sheikh, Eero Simoncelli, "Image Quality
/// Assessment: From Error Visibility to Structural Similarity", 2004.
std::vector<SsimSums> structural_similarity(const WindowedImage& truth, const WindowedImage& test,
                                            const PixelWeights& weights, std::span<const BlockGrid> grids,
                                            int halvings = 0);

}  // namespace aoscore
