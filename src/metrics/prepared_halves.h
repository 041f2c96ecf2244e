#pragma once

#include "core/image.h"
#include "metrics/prepared_image.h"

namespace aoscore {

/// A truth of two halves, and either half, prepared for windowed metrics.
///
/// Under SSIM's window the truth's noise adds its own variance to that of the truth; mean and covariance stay
/// as they are on average. Half the difference of the halves has the noise's variance, whatever it is at a
/// pixel, and none of the truth's, so that the variance of one taken off the other is the covariance of the
/// halves: that of the truth without noise, without bias. From either half twice as much is taken off, as its
/// noise has twice the variance. All three variances are right on average, and err twice as much (in the
/// variance of the error) for a half: what that does to a ratio whose denominator is uncertain is
/// extrapolated like the rest, see extrapolation.h. Variances are not let far below 0, which remains.
class PreparedHalves {
  public:
    /// All arguments must outlive this object; `mean` is that of the halves.
    PreparedHalves(const ImageF& mean, const ImageF& first_half, const ImageF& second_half,
                   const Mask& valid);

    PreparedImage whole;          ///< the mean, its noise's variance taken off, and its own variance beside
    PreparedImage first, second;  ///< the halves, their noise's variances taken off

    /// The memory of all of it, bytes a pixel.
    static constexpr double kBytesPerPixel = 3 * PreparedImage::kBytesPerPixel + 8;
};

}  // namespace aoscore
