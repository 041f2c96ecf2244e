#pragma once

#include "core/image.h"
#include "metrics/measures/pixel_weights.h"
#include "metrics/measures/seen_image.h"
#include "metrics/measures/structural_similarity.h"
#include "metrics/measures/window_moments.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace aoscore {

/// The part of windowed metrics that depends on one image alone: an image that is compared with several
/// others, as a truth is, need not be filtered for each. It is made when first needed, and kept; only one
/// thread may use it. Metrics have the same bits as without it.
class PreparedImage {
  public:
    /// Both arguments must outlive this object. Invalid pixels may be NaN.
    PreparedImage(const ImageF& image, const Mask& valid) : image_(image), valid_(valid) {}
    /// Prepares an image whose noise is like that of `noise`, an image of mean 0 that varies with it in
    /// nothing else: variances under SSIM's window are those of the image without it, and may be a little
    /// below 0. With `keeps_noisy`, windowed() also has those of the image itself, at the first scale.
    PreparedImage(const ImageF& image, const Mask& valid, ImageF noise, bool keeps_noisy = false)
        : image_(image), valid_(valid), keeps_noisy_(keeps_noisy), noise_(std::move(noise)) {}

    /// FLIP's features of the image.
    const SeenImage& seen() const;
    /// The image halved so many times, with its moments under SSIM's window (where it is larger than the
    /// window).
    WindowedImage windowed(std::size_t halvings) const;

    /// The memory of all of it in bytes a pixel: three numbers for FLIP, and two for SSIM at the first scale,
    /// a quarter of that at the second, and so on, with the images and weights of these scales.
    static constexpr double kBytesPerPixel = 3 * 8 + (2 * 8 + 2 * 4) * 4.0 / 3;

  private:
    struct Scale {
        ImageF halved;  ///< empty at the first scale, which is the image itself
        std::optional<WindowMoments> moments;
        std::optional<Image<double>> noisy_variance;
    };

    void add_scale() const;
    const ImageF& image_at(std::size_t halvings) const;

    const ImageF& image_;
    const Mask& valid_;
    bool keeps_noisy_ = false;
    mutable std::optional<SeenImage> seen_;
    mutable std::optional<PixelWeights> weights_;  ///< weights of the last scale
    mutable std::optional<ImageF> noise_;          ///< at the last scale
    mutable std::vector<Scale> scales_;
};

/// An image at successive scales, prepared or not.
class ScaledImage {
  public:
    /// `prepared` is null where it was not; all must outlive it.
    ScaledImage(const ImageF& image, const PreparedImage* prepared) : image_(image), prepared_(prepared) {}

    WindowedImage windowed() const;
    /// Halves the image; `weights` are those of its current size.
    void halve(const PixelWeights& weights);

  private:
    const ImageF& image_;
    const PreparedImage* prepared_;
    ImageF halved_;
    std::size_t halvings_ = 0;
};

}  // namespace aoscore
