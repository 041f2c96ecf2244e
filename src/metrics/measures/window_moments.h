#pragma once

#include "core/image.h"
#include "metrics/measures/pixel_weights.h"
#include "metrics/measures/window_filter.h"

#include <cstddef>
#include <vector>

namespace aoscore {

/// Mean and variance of an image under SSIM's window, around each pixel that is kSsimBorder_px or more
/// inside; the planes are smaller than the image by that on each side.
struct WindowMoments {
    Image<double> mean, variance;
};

/// The moments are normalised convolutions: pixels of weight 0, which may be NaN, contribute nothing. Hans
/// Knutsson, Carl-Fredrik Westin, "Normalized and Differential Convolution", 1993. The image must be larger
/// than the window.
WindowMoments window_moments(const ImageF& image, const PixelWeights& weights);

/// Weights row by row, and their sums under the window.
class MovingWeights {
  public:
    /// `weights` must outlive it.
    explicit MovingWeights(const PixelWeights& weights);

    /// Pushes the weights of row `y`, which must be the one after the last.
    const std::vector<double>& push(int y);
    /// The sums around the middle one of the last rows; 1 where all pixels count fully.
    const double* sums();

  private:
    const PixelWeights& weights_;
    WindowFilter filter_;
    std::vector<double> row_;
};

/// A row of WindowMoments.
struct MomentRow {
    const double *mean, *variance;
};

/// The moments of an image row by row.
class MovingMoments {
  public:
    explicit MovingMoments(std::size_t width);

    /// Pushes the next row: its values, 0 where they do not count, and their weights.
    void push(const std::vector<double>& values, const std::vector<double>& weights);
    /// The moments around the middle one of the last rows pushed.
    MomentRow row(const double* weight_sums);

  private:
    WindowFilter values_, squares_;
    std::vector<double> terms_, squared_terms_, mean_, variance_;
};

/// Reads the values of row `y`, 0 where they do not count.
void read_counting(const ImageF& image, int y, const std::vector<double>& weights,
                   std::vector<double>& values);

}  // namespace aoscore
